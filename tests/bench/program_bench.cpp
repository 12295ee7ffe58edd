// SPDX-License-Identifier: GPL-3.0-or-later
// Programs beside what a programmer would write (hand_written.h), and beside GiNaC: nanoseconds a sample in
// batches of 2,048, the least of many runs that take turns, in one process on the same data. Loops are
// compiled for this machine, and for the instruction set that RIGOR_INSTRUCTION_SET holds programs to. Fails
// if a program takes more than 1.5 times a loop of the same instruction set (of this machine, if programs are
// not held to less) on the least runs, if a compilation with the first value takes more than a thousandth of
// GiNaC's `compile_ex`, or if an evaluation takes more than a thousandth of GiNaC's `subs` and `evalf`.
#include <fmt/format.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench_clock.h"
#include "expr/build.h"
#include "hand_written.h"
#include "numeric/lane/lane_kernels.h"
#include "numeric/measure/evaluate.h"
#include "numeric/run/run_samples_parts.h"
#include "numeric/run/runner.h"

namespace rigor {

extern template class Engine<double>;

namespace bench {
namespace {

using namespace rigor::build;

constexpr std::size_t samples = 2048;
constexpr int rounds = 300;
constexpr double most_times_hand_written = 1.5;
constexpr double least_times_ginac = 1000.0;

/// The page that all forms are written on, and numbers for it.
struct Bench {
  explicit Bench(std::size_t particles) : data(samples, particles) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.5, 1.5);
    const auto column = [&](std::size_t count) {
      std::vector<double> values(count);
      for (double& value : values) value = uniform(random);
      return values;
    };
    data.set_particles(m.symbol, 0, column(particles));
    for (std::uint32_t i = 0; i < 3; ++i) {
      data.set_particles(r.symbol, i, column(particles));
      for (const Named& each : {a, b, w}) data.set_each(each.symbol, i, column(samples));
      data.set(moment[i].symbol, 0, uniform(random));
    }
    page.define(inertia,
                over(alpha, m(alpha) * (squared(r(alpha)) * page.delta(i_, j_) -
                                        at(r(alpha), i_) * at(r(alpha), j_))),
                {i_, j_});
  }

  [[nodiscard]] Program compile(const Term& term) const {
    const ProgramRoot root{term.id, {}};
    return *Program::compile(page.tree, page.question.definitions, std::span(&root, 1));
  }
  [[nodiscard]] Columns columns(const Named& of) const {
    return {data.find(of.symbol, 0)->values.data(), data.find(of.symbol, 1)->values.data(),
            data.find(of.symbol, 2)->values.data()};
  }
  [[nodiscard]] PointMasses body() const {
    return {data.find(m.symbol, 0)->values.data(), columns(r), data.particles()};
  }

  Page page;
  Named a = page.vector("A");
  Named b = page.vector("B");
  Named w = page.vector("\\omega");
  Named moment[3] = {page.scalar("I_1"), page.scalar("I_2"), page.scalar("I_3")};
  Named m = page.scalars("m");
  Named r = page.vectors("r");
  Named inertia = page.symmetric("I");
  ParticleId alpha = page.particle("\\alpha");
  IndexId i_ = page.index("i");
  IndexId j_ = page.index("j");
  Samples data;
};

struct Times {
  double program = 0.0;
  double same = 0.0;    // the loop with the same instructions
  double native = 0.0;  // and with all that the machine has
};

using Loop = std::function<void(const HandWritten& loops, double* results)>;

[[nodiscard]] const HandWritten& loops_of_same_instructions() {
  const LaneKernels& widest = *runnable_lane_kernels().back();
  return &lane_kernels() == &widest ? native::loops : loops_for(lane_kernels().instruction_set);
}

/// All in turns; the results are compared.
[[nodiscard]] Times measure(const Bench& bench, const Term& term, const Loop& hand_written) {
  const Program program = bench.compile(term);
  SampleEngine<double> engine(program, bench.data, Lanes::samples, {});
  const std::vector<double>& ours = engine.run();
  std::vector<double> theirs(samples * program.outputs());
  const auto run_program = [&] { engine.run(); };
  const auto run_same = [&] { hand_written(loops_of_same_instructions(), theirs.data()); };
  const auto run_native = [&] { hand_written(native::loops, theirs.data()); };
  const std::size_t program_repeats = repeats_of(run_program);
  const std::size_t same_repeats = repeats_of(run_same);
  const std::size_t native_repeats = repeats_of(run_native);
  Times least{1e300, 1e300, 1e300};
  for (int round = 0; round < rounds; ++round) {
    least.program = std::min(least.program, nanoseconds_of(run_program, program_repeats));
    least.same = std::min(least.same, nanoseconds_of(run_same, same_repeats));
    least.native = std::min(least.native, nanoseconds_of(run_native, native_repeats));
  }
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::abs(ours[i] - theirs[i]) > 1e-9 * std::abs(theirs[i]) + 1e-9)
      throw std::runtime_error("a program and the hand-written loop differ");
  }
  return {least.program / samples, least.same / samples, least.native / samples};
}

class Table {
 public:
  void row(const std::string& name, const Times& times) {
    const double ratio = times.program / times.same;
    fmt::print("{:<50}{:>9.2f}{:>14.2f}{:>8.2f}{:>8.2f}\n", name, times.program, times.same, ratio,
               times.program / times.native);
    good_ = good_ && ratio <= most_times_hand_written;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  bool good_ = true;
};

[[nodiscard]] bool beside_hand_written() {
  fmt::print("{:<50}{:>9}{:>14}{:>8}{:>8}\n", fmt::format("ns a sample, {}", lane_kernels().instruction_set),
             "program", "hand-written", "ratio", "native");
  Table table;
  Bench one(0);
  const Columns a = one.columns(one.a);
  const Columns b = one.columns(one.b);
  table.row("|AxB|^2", measure(one, squared(cross(one.a, one.b)), [&](const HandWritten& loops, double* out) {
              loops.cross_square(a, b, samples, out);
            }));
  table.row("A^2 B^2 - (A.B)^2",
            measure(one, squared(one.a) * squared(one.b) - pow(dot(one.a, one.b), 2),
                    [&](const HandWritten& loops, double* out) { loops.dot_squares(a, b, samples, out); }));
  const auto triple = [](double* out) {
    return std::array<double*, 3>{out, out + samples, out + 2 * samples};
  };
  const auto rate = [&](int i) {
    const int j = i % 3 + 1;
    const int k = j % 3 + 1;
    return (one.moment[j - 1] - one.moment[k - 1]) * at(one.w, j) * at(one.w, k) / one.moment[i - 1];
  };
  std::array<double, 3> moments{};
  for (std::size_t i = 0; i < 3; ++i) moments[i] = one.data.find(one.moment[i].symbol, 0)->values[0];
  table.row("Euler's equations",
            measure(one, tuple(rate(1), rate(2), rate(3)), [&](const HandWritten& loops, double* out) {
              loops.euler_rates(moments, one.columns(one.w), samples, triple(out));
            }));
  for (const std::size_t particles : {8u, 100u}) {
    Bench many(particles);
    const auto of = [&](const char* name) { return fmt::format("{}, {} particles", name, particles); };
    const PointMasses body = many.body();
    const Columns w = many.columns(many.w);
    const Named v = many.r(many.alpha);
    const Named m = many.m(many.alpha);
    const Term half = many.page.number("1") / 2;
    table.row(of("T = 1/2 sum m |w x r|^2"),
              measure(many, half * over(many.alpha, m * squared(cross(many.w, v))),
                      [&](const HandWritten& loops, double* out) {
                        loops.energy_from_speed(body, w, samples, out);
                      }));
    const Term distance = squared(many.w) * squared(v) - pow(dot(many.w, v), 2);
    table.row(
        of("T = 1/2 sum m (w^2 r^2 - (w.r)^2)"),
        measure(many, half * over(many.alpha, m * distance), [&](const HandWritten& loops, double* out) {
          loops.energy_from_distance(body, w, samples, out);
        }));
    const Term quadratic = half * sum({many.i_, many.j_}, at(many.inertia, many.i_, many.j_) *
                                                              at(many.w, many.i_) * at(many.w, many.j_));
    table.row(of("T = 1/2 I_ij w_i w_j"),
              measure(many, quadratic, [&](const HandWritten& loops, double* out) {
                loops.energy_from_inertia(body, w, samples, out);
              }));
    table.row(of("L = sum m r x (w x r)"), measure(many, over(many.alpha, m * cross(v, cross(many.w, v))),
                                                   [&](const HandWritten& loops, double* out) {
                                                     loops.angular_momentum(body, w, samples, triple(out));
                                                   }));
  }
  return table.good();
}

/// One call at a time, as in the right-hand side of a differential equation.
void in_a_loop() {
  Bench one(0);
  const auto rate = [&](int i) {
    const int j = i % 3 + 1;
    const int k = j % 3 + 1;
    return (one.moment[j - 1] - one.moment[k - 1]) * at(one.w, j) * at(one.w, k) / one.moment[i - 1];
  };
  const Program program = one.compile(tuple(rate(1), rate(2), rate(3)));
  const std::array<ProgramInput, 3> spin{{{one.w.symbol, 0}, {one.w.symbol, 1}, {one.w.symbol, 2}}};
  Samples fixed(1, 0);
  for (const Named& each : one.moment) fixed.set(each.symbol, 0, one.data.find(each.symbol, 0)->values[0]);
  Runner runner(program, fixed, spin);
  std::array<double, 3> state{0.6, 0.7, 0.9};
  std::array<double, 3> rates{};
  constexpr int calls = 100'000;
  const double least = least_nanoseconds([&] {
    for (int i = 0; i < calls; ++i) {
      runner(state.data(), rates.data());
      state[0] += 1e-9 * rates[0];
    }
  });
  fmt::print("\nEuler's equations, one call at a time: {:.1f} ns\n", least / calls);
}

/// Infinite where there is no `ginac-excompiler`.
[[nodiscard]] double compile_ex_time(const GiNaC::ex& value, const std::vector<GiNaC::symbol>& names) {
  GiNaC::lst arguments;
  for (const GiNaC::symbol& name : names) arguments.append(name);
  double least = std::numeric_limits<double>::infinity();
  try {
    for (int round = 0; round < 3; ++round) {
      GiNaC::FUNCP_CUBA compiled = nullptr;
      GiNaC::lst results{value};
      least = std::min(least, nanoseconds_of([&] { GiNaC::compile_ex(results, arguments, compiled); }, 1));
    }
  } catch (const std::runtime_error& error) {
    fmt::print("compile_ex: {} (Debian package ginac-tools)\n", error.what());
  }
  return least;
}

[[nodiscard]] bool beside_ginac() {
  Bench one(0);
  const Term term = squared(cross(one.a, one.b));
  Samples single(1, 0);
  for (std::uint32_t i = 0; i < 3; ++i) {
    single.set_each(one.a.symbol, i, {0.5 + i});
    single.set_each(one.b.symbol, i, {2.0 - i * i});
  }
  double value = 0.0;
  const double compile = least_nanoseconds([&] { static_cast<void>(one.compile(term)); });
  const double first = least_nanoseconds([&] { value = evaluate(one.compile(term), single)[0]; });
  std::vector<GiNaC::symbol> names;
  for (const char* name : {"a1", "a2", "a3", "b1", "b2", "b3"}) names.emplace_back(name);
  GiNaC::ex square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    square += GiNaC::pow(names[j] * names[3 + k] - names[k] * names[3 + j], 2);
  }
  GiNaC::exmap at;
  for (std::size_t i = 0; i < 3; ++i) {
    at[names[i]] = 0.5 + static_cast<double>(i);
    at[names[3 + i]] = 2.0 - static_cast<double>(i * i);
  }
  double theirs = 0.0;
  const double evalf =
      least_nanoseconds([&] { theirs = GiNaC::ex_to<GiNaC::numeric>(square.subs(at).evalf()).to_double(); });
  const double compile_ex = compile_ex_time(square, names);
  const Times batch = measure(one, term, [&](const HandWritten& loops, double* out) {
    loops.cross_square(one.columns(one.a), one.columns(one.b), samples, out);
  });
  fmt::print("\n|AxB|^2 beside GiNaC (values {} and {})\n", value, theirs);
  fmt::print("compile: {:.2f} us, with the first value {:.2f} us; compile_ex: {:.0f} us, {:.0f} times\n",
             compile / 1e3, first / 1e3, compile_ex / 1e3, compile_ex / first);
  fmt::print("a sample: {:.2f} ns; subs and evalf: {:.0f} ns, {:.0f} times\n", batch.program, evalf,
             evalf / batch.program);
  if (std::isinf(compile_ex)) fmt::print("compile_ex was not measured: ginac-excompiler is not installed\n");
  return compile_ex >= least_times_ginac * first && evalf >= least_times_ginac * batch.program;
}

}  // namespace
}  // namespace bench
}  // namespace rigor

int main() {
  const bool near_hand_written = rigor::bench::beside_hand_written();
  rigor::bench::in_a_loop();
  const bool far_from_ginac = rigor::bench::beside_ginac();
  return near_hand_written && far_from_ginac ? 0 : 1;
}
