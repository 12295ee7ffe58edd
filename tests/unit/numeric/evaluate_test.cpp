// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/evaluate.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <tuple>

#include "catch.h"
#include "numeric/measure/bounds.h"
#include "numeric/on_sample.h"
#include "numeric/program/code.h"
#include "numeric/random_forms.h"
#include "numeric/rounded_reference.h"
#include "numeric/run/run_engine.h"
#include "numeric/run/run_samples.h"

using namespace rigor;
using namespace rigor::build;

namespace {

constexpr std::array all_arithmetics{Arithmetic::single, Arithmetic::plain, Arithmetic::extended,
                                     Arithmetic::double_double};

[[nodiscard]] bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

[[nodiscard]] bool same_bits_or_nan(const std::vector<double>& a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::isnan(a[i]) && std::isnan(b[i])) && a[i] != b[i]) return false;
  }
  return a.size() == b.size();
}

/// The program's values in order, each rounded by itself: no plan, no steps. Without loops.
[[nodiscard]] double separately(const Program& program, const Samples& samples, std::size_t sample) {
  const Code& code = program.code();
  std::vector<double> values;
  for (const Value& value : code.values) {
    const double a = has_operands(value.op) ? values[value.a] : 0.0;
    const double b = has_second_operand(value.op) ? values[value.b] : 0.0;
    switch (value.op) {
      case Instruction::constant:
        values.push_back(code.constants[value.a].value);
        break;
      case Instruction::input: {
        const ProgramInput& input = code.inputs[value.a];
        const Column& column = *samples.find(input.symbol, input.component);
        values.push_back(column.values[sample * column.sample_stride]);
        break;
      }
      case Instruction::add:
        values.push_back(a + b);
        break;
      case Instruction::subtract:
        values.push_back(a - b);
        break;
      case Instruction::multiply:
        values.push_back(a * b);
        break;
      case Instruction::divide:
        values.push_back(a / b);
        break;
      case Instruction::negate:
        values.push_back(-a);
        break;
      case Instruction::root:
        values.push_back(std::sqrt(a));
        break;
      case Instruction::absolute:
        values.push_back(std::abs(a));
        break;
      case Instruction::sin:
        values.push_back(std::sin(a));
        break;
      case Instruction::cos:
        values.push_back(std::cos(a));
        break;
      case Instruction::exp:
        values.push_back(std::exp(a));
        break;
      case Instruction::tan:
        values.push_back(std::tan(a));
        break;
      case Instruction::sinh:
        values.push_back(std::sinh(a));
        break;
      case Instruction::cosh:
        values.push_back(std::cosh(a));
        break;
      case Instruction::tanh:
        values.push_back(std::tanh(a));
        break;
      case Instruction::sum:
        values.push_back(0.0);
        break;
    }
  }
  return values[code.outputs[0]];
}

[[nodiscard]] std::vector<double> one_by_one(const Program& program, const Samples& samples) {
  std::vector<double> values;
  for (std::size_t i = 0; i < samples.samples(); ++i) values.push_back(separately(program, samples, i));
  return values;
}

class Numbers {
 public:
  [[nodiscard]] std::vector<double> operator()(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = uniform_(random_);
    return values;
  }

 private:
  std::mt19937_64 random_{20};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// A body of `particles`, and its spin for each sample.
struct Spinning {
  Spinning(std::size_t samples, std::size_t particles) : data(samples, particles) {
    Numbers numbers;
    data.set_particles(m.symbol, 0, numbers(particles));
    for (std::uint32_t i = 0; i < 3; ++i) data.set_particles(r.symbol, i, numbers(particles));
    for (std::uint32_t i = 0; i < 3; ++i) data.set_each(w.symbol, i, numbers(samples));
    energy = over(alpha, m(alpha) * squared(cross(w, r(alpha)))) / 2;
  }
  Page page;
  Named m = page.scalars("m");
  Named r = page.vectors("r");
  Named w = page.vector("w");
  ParticleId alpha = page.particle("\\alpha");
  Term energy;
  Samples data;
};

/// The same columns, one sample of them.
[[nodiscard]] Samples only(const Spinning& spinning, std::size_t sample) {
  Samples one(1, spinning.data.particles());
  one.set_particles(spinning.m.symbol, 0, spinning.data.find(spinning.m.symbol, 0)->values);
  for (std::uint32_t i = 0; i < 3; ++i) {
    one.set_particles(spinning.r.symbol, i, spinning.data.find(spinning.r.symbol, i)->values);
    one.set_each(spinning.w.symbol, i, {spinning.data.find(spinning.w.symbol, i)->values[sample]});
  }
  return one;
}

}  // namespace

TEST_CASE("the low part of a value counts in arithmetic that has room for it", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program program = compiled(page, x - y);
  Samples samples(2, 0);
  samples.set(x.symbol, 0, HighLow{1, 0x1p-60});
  samples.set(y.symbol, 0, HighLow{1, -0x1p-70});
  CHECK(evaluate(program, samples, Arithmetic::double_double) == std::vector<double>(2, 0x1p-60 + 0x1p-70));
  CHECK(evaluate(program, samples, Arithmetic::extended) == std::vector<double>(2, 0x1p-60));
  CHECK(evaluate(program, samples, Arithmetic::plain) == std::vector<double>(2, 0));
  const BoundedResults bounded = evaluate_with_bounds(program, samples);
  CHECK(bounded.bounds[0] >= 0x1p-60 + 0x1p-70);
  CHECK(evaluate(program, samples.only(std::vector<std::size_t>{1}), Arithmetic::double_double)[0] > 0);
}

TEST_CASE("a batch of any size gives what single samples give, bit for bit", "[numeric]") {
  for (const std::size_t samples : {0u, 1u, 63u, 64u, 65u, 127u, 128u, 129u, 1100u}) {
    Spinning spinning(samples, 5);
    const Program program = compiled(spinning.page, spinning.energy);
    for (const Arithmetic arithmetic : all_arithmetics) {
      const std::vector<double> batch = evaluate(program, spinning.data, arithmetic);
      std::vector<double> single;
      for (std::size_t i = 0; i < samples; ++i)
        single.push_back(evaluate(program, only(spinning, i), arithmetic)[0]);
      CAPTURE(samples, name_of(arithmetic));
      CHECK(same_bits(batch, single));
    }
  }
}

TEST_CASE("lanes of particles and lanes of samples agree but for the order of the sum", "[numeric]") {
  for (const std::size_t particles : {0u, 1u, 2u, 127u, 128u, 129u, 1000u}) {
    Spinning spinning(3, particles);
    const Program program = compiled(spinning.page, spinning.energy);
    const auto by_samples = run_on_samples<double>(program, spinning.data, Lanes::samples, {});
    const auto by_particles = run_on_samples<double>(program, spinning.data, Lanes::particles, {});
    const auto one_by_one = run_on_samples<double>(program, spinning.data, Lanes::none, {});
    CHECK(same_bits(by_samples, one_by_one));
    for (std::size_t i = 0; i < by_samples.size(); ++i) {
      // |Σ − Σ'| ≤ 2 n u Σ|term|; each term is below 12 · ½.
      const double n = static_cast<double>(particles);
      CHECK(std::abs(by_samples[i] - by_particles[i]) <= 2.0 * n * 0x1p-53 * n * 6.0);
      CHECK((particles > 0 || by_particles[i] == 0.0));
    }
  }
}

TEST_CASE("sums within sums agree with the reference, whatever the lanes are", "[numeric]") {
  for (const std::size_t particles : {1u, 5u, 150u}) {
    Spinning spinning(2, particles);
    const ParticleId beta = spinning.page.particle("\\beta");
    const auto [m, r, alpha] = std::tuple(spinning.m, spinning.r, spinning.alpha);
    const Term inner = over(beta, m(beta) * squared(r(alpha) - r(beta)) * dot(spinning.w, r(beta)));
    const Program program =
        compiled(spinning.page, over(alpha, m(alpha) * inner * dot(r(alpha), r(alpha))) /
                                    (spinning.page.number("1") + over(alpha, squared(m(alpha)))));
    const Reference exact = reference(program, spinning.data);
    const BoundedResults bounded = evaluate_with_bounds(program, spinning.data);
    for (const Lanes lanes : {Lanes::none, Lanes::one, Lanes::samples, Lanes::particles}) {
      const auto values = run_on_samples<double>(program, spinning.data, lanes, {});
      for (std::size_t i = 0; i < values.size(); ++i)
        CHECK(std::abs(values[i] - exact.values[i]) <= 2.0 * bounded.bounds[i]);
    }
  }
}

TEST_CASE("what all samples have in common gives the same as what they have not", "[numeric]") {
  for (const std::size_t particles : {2u, 300u}) {
    Spinning spinning(5, particles);
    const IndexId i = spinning.page.index("i");
    const IndexId j = spinning.page.index("j");
    const auto [m, r, w, alpha] = std::tuple(spinning.m, spinning.r, spinning.w, spinning.alpha);
    const Named inertia = spinning.page.tensor("I");
    spinning.page.define(inertia,
                         over(alpha, m(alpha) * (squared(r(alpha)) * spinning.page.delta(i, j) -
                                                 at(r(alpha), i) * at(r(alpha), j))),
                         {i, j});
    const Program by_tensor =
        compiled(spinning.page, sum({i, j}, at(inertia, i, j) * at(w, i) * at(w, j)) / 2);
    const Program by_speed = compiled(spinning.page, spinning.energy);
    const std::vector<double> one = evaluate(by_tensor, spinning.data);
    const std::vector<double> other = evaluate(by_speed, spinning.data);
    const BoundedResults first = evaluate_with_bounds(by_tensor, spinning.data);
    const BoundedResults second = evaluate_with_bounds(by_speed, spinning.data);
    for (std::size_t k = 0; k < one.size(); ++k)
      CHECK(std::abs(one[k] - other[k]) <= 2.0 * (first.bounds[k] + second.bounds[k]));
  }
}

TEST_CASE("fused steps round as separate ones do", "[numeric]") {
  RandomForms forms;
  Numbers numbers;
  constexpr std::size_t count = 130;
  Samples samples(count, 0);
  for (const Named& vector : forms.page.vectors_of) {
    for (std::uint32_t i = 0; i < 3; ++i) samples.set_each(vector.symbol, i, numbers(count));
  }
  for (int form = 0; form < 200; ++form) {
    const Term term = forms.scalar(3);
    const Program program = compiled(forms.page, term);
    for (const bool same : {false, true}) {  // products with one wide factor, too
      Samples here = samples;
      for (std::uint32_t i = 0; same && i < 3; ++i)
        here.set(forms.page.vectors_of[0].symbol, i, 0.7 - 0.4 * static_cast<double>(i));
      const std::vector<double> values = evaluate(program, here);
      CHECK(same_bits_or_nan(values, one_by_one(program, here)));
    }
  }
}

TEST_CASE("large fused steps round as separate ones do, whatever is the same for all samples", "[numeric]") {
  Page page;
  const std::array<Named, 2> v{page.vector("A"), page.vector("B")};
  const Named s = page.tensor("S");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const Term form = sum({i, j}, at(s, i, j) * at(v[0], i) * at(v[0], j));
  const std::array<Term, 7> terms{squared(v[0]) * squared(v[1]) - pow(dot(v[0], v[1]), 2),
                                  at(s, 1, 1) * at(v[0], 1) - pow(dot(v[0], v[1]), 2),
                                  form,
                                  -form / 3,
                                  -(at(v[0], 1) * at(s, 1, 2)) * at(s, 2, 1) / at(s, 3, 3),
                                  -dot(v[0], v[1]) * at(s, 1, 1) - at(s, 1, 2) * dot(cross(v[0], v[1]), v[0]),
                                  squared(cross(v[0], v[1])) / at(s, 2, 2)};
  Numbers numbers;
  for (const std::size_t count : {130u, 1100u}) {
    for (const unsigned varying : {0b111u, 0b011u, 0b001u, 0b010u, 0b100u}) {
      Samples samples(count, 0);
      const auto set = [&](const Named& each, std::uint32_t components, bool varies) {
        for (std::uint32_t k = 0; k < components; ++k) {
          if (varies)
            samples.set_each(each.symbol, k, numbers(count));
          else
            samples.set(each.symbol, k, numbers(1)[0]);
        }
      };
      for (unsigned k = 0; k < 2; ++k) set(v[k], 3, (varying >> k & 1u) != 0);
      set(s, 9, (varying >> 2 & 1u) != 0);
      for (const Term& term : terms) {
        const Program program = compiled(page, term);
        CHECK(same_bits_or_nan(evaluate(program, samples), one_by_one(program, samples)));
      }
    }
  }
}

TEST_CASE("components that are computed together are those that are computed alone", "[numeric]") {
  for (const std::size_t samples : {2u, 130u, 1100u}) {
    Spinning spinning(samples, 21);
    const auto [m, r, w, alpha] = std::tuple(spinning.m, spinning.r, spinning.w, spinning.alpha);
    const Named momentum = spinning.page.vector("L");
    spinning.page.define(momentum, over(alpha, m(alpha) * cross(r(alpha), cross(w, r(alpha)))));
    const Named rate = spinning.page.vector("N");
    spinning.page.define(rate, cross(momentum, w));
    for (const Lanes lanes : {Lanes::none, Lanes::samples, Lanes::particles}) {
      for (const Named& vector : {momentum, rate}) {
        const Program all = compiled(spinning.page, tuple(at(vector, 1), at(vector, 2), at(vector, 3)));
        const auto together = run_on_samples<double>(all, spinning.data, lanes, {});
        std::vector<double> alone;
        for (int k = 1; k <= 3; ++k) {
          const auto one =
              run_on_samples<double>(compiled(spinning.page, at(vector, k)), spinning.data, lanes, {});
          alone.insert(alone.end(), one.begin(), one.end());
        }
        CHECK(same_bits(together, alone));
      }
    }
  }
}

TEST_CASE("sums over particles have the same bits where columns are copied and where they are not",
          "[numeric]") {
  for (const std::size_t samples : {1u, 128u, 130u, 520u, 2048u}) {
    for (const std::size_t particles : {particles_worth_copies - 1, particles_worth_copies}) {
      Spinning spinning(samples, particles);
      const auto [m, r, w, alpha] = std::tuple(spinning.m, spinning.r, spinning.w, spinning.alpha);
      const Named momentum = spinning.page.vector("L");
      spinning.page.define(momentum, over(alpha, m(alpha) * cross(r(alpha), cross(w, r(alpha)))));
      const Program program = compiled(spinning.page, tuple(at(momentum, 1), at(w, 2), at(momentum, 3)));
      CHECK(same_bits(run_on_samples<double>(program, spinning.data, Lanes::samples, {}),
                      run_on_samples<double>(program, spinning.data, Lanes::none, {})));
    }
  }
}

TEST_CASE("NaN and infinity pass through a program", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Program program = compiled(page, dot(a, a));
  Samples samples(3, 0);
  const double infinity = std::numeric_limits<double>::infinity();
  samples.set_each(a.symbol, 0, {std::numeric_limits<double>::quiet_NaN(), infinity, 1e200});
  samples.set(a.symbol, 1, 0.0);
  samples.set(a.symbol, 2, 2.0);
  for (const Arithmetic arithmetic : {Arithmetic::single, Arithmetic::plain, Arithmetic::extended}) {
    const std::vector<double> values = evaluate(program, samples, arithmetic);
    CHECK(std::isnan(values[0]));
    CHECK(values[1] == infinity);
    CHECK(values[2] == infinity);  // rounded to double at the end
  }
  CHECK_FALSE(std::isfinite(evaluate(program, samples, Arithmetic::double_double)[1]));
}

TEST_CASE("each arithmetic rounds as it should", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Program third = compiled(page, 1 / (x * page.number("3")));
  Samples samples(1, 0);
  samples.set_each(x.symbol, 0, {1.0});
  CHECK(evaluate(third, samples, Arithmetic::single)[0] == static_cast<double>(1.0f / 3.0f));
  CHECK(evaluate(third, samples)[0] == 1.0 / 3.0);
  const Program rest = compiled(page, x - (1 / (x * page.number("3"))) * page.number("3"));
  samples.set_each(x.symbol, 0, {1.25});
  CHECK(evaluate(rest, samples, Arithmetic::double_double)[0] == 0.45);
  const Program tenth = compiled(page, x * page.number("0.1"));
  CHECK(evaluate(tenth, samples, Arithmetic::single)[0] == static_cast<double>(1.25f * 0.1f));
  CHECK(evaluate(tenth, samples)[0] == 1.25 * 0.1);
  CHECK(evaluate(tenth, samples, Arithmetic::double_double)[0] == 0.125);
}

TEST_CASE("functions and roots are those of the library", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Program program = compiled(page, tuple(sin(x) + cos(-x), exp(x), root(x)));
  Samples samples(70, 0);
  std::vector<double> values = Numbers()(70);
  samples.set_each(x.symbol, 0, values);
  for (const Arithmetic arithmetic : {Arithmetic::plain, Arithmetic::double_double}) {
    const std::vector<double> results = evaluate(program, samples, arithmetic);
    for (std::size_t i = 0; i < values.size(); ++i) {
      CHECK(results[i] == Approx(std::sin(values[i]) + std::cos(values[i])).epsilon(1e-14));
      CHECK(results[70 + i] == Approx(std::exp(values[i])).epsilon(1e-15));
      if (values[i] < 0.0)
        CHECK(std::isnan(results[140 + i]));
      else
        CHECK(results[140 + i] == std::sqrt(values[i]));
    }
  }
}
