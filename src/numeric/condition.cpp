// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/condition.h"

#include <algorithm>
#include <array>
#include <bit>

#include "numeric/reference_digits.h"
#include "numeric/run_samples.h"

namespace rigor {
namespace {

using Number = Decimal<100>;

/// All values of a program at one sample, for all particles of the loops that they are in, and how a result
/// depends on each.
class Tape {
 public:
  Tape(const Program& program, const Samples& samples, std::span<const std::uint32_t> at)
      : program_(program), code_(program.code()), samples_(samples), at_(at) {
    first_.reserve(code_.values.size());
    for (const Value& value : code_.values) {
      first_.push_back(elements_);
      elements_ += tuples(value.levels);
      work_ += tuples(value.op == Instruction::sum ? code_.values[value.a].levels : value.levels);
    }
    for (const ProgramInput& input : program.inputs()) {
      const Column& column = *samples.find(input.symbol, input.component);
      gradient_first_.push_back(gradient_count_);
      gradient_count_ += column.particle_stride == 0 ? 1 : samples.particles();
    }
  }

  /// Operations for one sample.
  [[nodiscard]] std::size_t work() const { return work_ * (1 + program_.outputs()); }
  [[nodiscard]] double condition(std::size_t sample);

 private:
  using Tuple = std::array<std::size_t, deepest_level + 1>;

  [[nodiscard]] std::size_t tuples(unsigned levels) const {
    std::size_t count = 1;
    for (int i = std::popcount(levels); i > 0; --i) count *= samples_.particles();
    return count;
  }
  /// Calls visit(particles, k) for all particles of the levels.
  template <class Visit>
  void for_each(unsigned levels, const Visit& visit) const;
  [[nodiscard]] std::size_t element(ValueId id, const Tuple& particles) const;
  [[nodiscard]] std::size_t particle_of(const Value& input, const Tuple& particles) const;
  [[nodiscard]] Number input(const Value& value, const Tuple& particles, std::size_t sample) const;

  void run(std::size_t sample);
  [[nodiscard]] Number compute(const Value& value, const Tuple& particles, std::size_t sample) const;
  void differentiate(ValueId output);
  void pass_on(ValueId id, const Tuple& particles);

  const Program& program_;
  const Code& code_;
  const Samples& samples_;
  std::span<const std::uint32_t> at_;
  std::vector<std::size_t> first_;  // by value: into the next two
  std::vector<Number> value_;
  std::vector<Number> adjoint_;
  std::vector<std::size_t> gradient_first_;  // by input: into the next
  std::vector<Number> gradient_;
  std::size_t elements_ = 0;
  std::size_t gradient_count_ = 0;
  std::size_t work_ = 0;
};

template <class Visit>
void Tape::for_each(unsigned levels, const Visit& visit) const {
  const std::size_t count = tuples(levels);
  for (std::size_t k = 0; k < count; ++k) {
    Tuple particles{};
    std::size_t rest = k;
    for (std::size_t level = 1; level <= deepest_level; ++level) {
      if ((levels >> level & 1u) == 0) continue;
      particles[level] = rest % samples_.particles();
      rest /= samples_.particles();
    }
    visit(particles);
  }
}

std::size_t Tape::element(ValueId id, const Tuple& particles) const {
  std::size_t at = 0;
  std::size_t scale = 1;
  for (std::size_t level = 1; level <= deepest_level; ++level) {
    if ((code_.values[id].levels >> level & 1u) == 0) continue;
    at += scale * particles[level];
    scale *= samples_.particles();
  }
  return first_[id] + at;
}

std::size_t Tape::particle_of(const Value& input, const Tuple& particles) const {
  if (input.b == InputParticle::none) return 0;
  return input.b >= InputParticle::first_free ? at_[input.b - InputParticle::first_free] : particles[input.b];
}

Number Tape::input(const Value& value, const Tuple& particles, std::size_t sample) const {
  const ProgramInput& named = code_.inputs[value.a];
  const Column& column = *samples_.find(named.symbol, named.component);
  return column
      .values[sample * column.sample_stride + particle_of(value, particles) * column.particle_stride];
}

Number Tape::compute(const Value& value, const Tuple& particles, std::size_t sample) const {
  const auto a = [&]() -> const Number& { return value_[element(value.a, particles)]; };
  const auto b = [&]() -> const Number& { return value_[element(value.b, particles)]; };
  using Traits = NumberTraits<Number>;
  switch (value.op) {
    case Instruction::constant:
      return number_of<Number>(code_.constants[value.a]);
    case Instruction::input:
      return input(value, particles, sample);
    case Instruction::add:
      return a() + b();
    case Instruction::subtract:
      return a() - b();
    case Instruction::multiply:
      return a() * b();
    case Instruction::divide:
      return a() / b();
    case Instruction::negate:
      return -a();
    case Instruction::root:
      return Traits::root(a());
    case Instruction::absolute:
      return Traits::absolute(a());
    case Instruction::sin:
      return Traits::sine(a());
    case Instruction::cos:
      return Traits::cosine(a());
    case Instruction::exp:
      return Traits::exponential(a());
    case Instruction::sum:
      break;
  }
  return 0;
}

void Tape::run(std::size_t sample) {
  value_.assign(elements_, Number(0));
  for (ValueId id = 0; id < code_.values.size(); ++id) {
    const Value& value = code_.values[id];
    if (value.op == Instruction::sum) {
      const unsigned levels = code_.values[value.a].levels | 1u << value.level;
      for_each(levels, [&](const Tuple& particles) {
        value_[element(id, particles)] += value_[element(value.a, particles)];
      });
    } else {
      for_each(value.levels, [&](const Tuple& particles) {
        value_[element(id, particles)] = compute(value, particles, sample);
      });
    }
  }
}

/// Adds to its operands' adjoints what comes through one value.
void Tape::pass_on(ValueId id, const Tuple& particles) {
  const Value& value = code_.values[id];
  const Number& here = adjoint_[element(id, particles)];
  if (here == 0) return;
  if (value.op == Instruction::input) {
    const ProgramInput& named = code_.inputs[value.a];
    const bool each = samples_.find(named.symbol, named.component)->particle_stride != 0;
    gradient_[gradient_first_[value.a] + (each ? particle_of(value, particles) : 0)] += here;
    return;
  }
  if (!has_operands(value.op)) return;
  const std::size_t at_a = element(value.a, particles);
  const std::size_t at_b = has_second_operand(value.op) ? element(value.b, particles) : at_a;
  const Number& result = value_[element(id, particles)];
  const Number& a = value_[at_a];
  const Number& b = value_[at_b];
  Number to_a = here;
  switch (value.op) {
    case Instruction::add:
      adjoint_[at_b] += here;
      break;
    case Instruction::subtract:
      adjoint_[at_b] -= here;
      break;
    case Instruction::multiply:
      adjoint_[at_b] += here * a;
      to_a *= b;
      break;
    case Instruction::divide:
      adjoint_[at_b] -= here * result / b;
      to_a /= b;
      break;
    case Instruction::negate:
      to_a = -here;
      break;
    case Instruction::root:
      to_a /= 2 * result;
      break;
    case Instruction::absolute:
      if (a < 0) to_a = -here;
      break;
    case Instruction::sin:
      to_a *= NumberTraits<Number>::cosine(a);
      break;
    case Instruction::cos:
      to_a *= -NumberTraits<Number>::sine(a);
      break;
    case Instruction::exp:
      to_a *= result;
      break;
    case Instruction::sum:
    case Instruction::constant:
    case Instruction::input:
      break;
  }
  adjoint_[at_a] += to_a;
}

void Tape::differentiate(ValueId output) {
  adjoint_.assign(elements_, Number(0));
  gradient_.assign(gradient_count_, Number(0));
  adjoint_[first_[output]] = 1;
  for (ValueId id = output + 1; id-- > 0;) {
    const Value& value = code_.values[id];
    const unsigned levels =
        value.op == Instruction::sum ? code_.values[value.a].levels | 1u << value.level : value.levels;
    for_each(levels, [&](const Tuple& particles) { pass_on(id, particles); });
  }
}

double Tape::condition(std::size_t sample) {
  run(sample);
  Number size = 0;
  std::vector<Number> largest(gradient_count_, Number(0));  // over the results
  for (const ValueId output : code_.outputs) {
    const Number& result = value_[first_[output]];
    if (!boost::multiprecision::isfinite(result)) return std::numeric_limits<double>::quiet_NaN();
    size = std::max(size, Number(abs(result)));
    differentiate(output);
    for (std::size_t i = 0; i < gradient_count_; ++i) {
      if (!boost::multiprecision::isfinite(gradient_[i])) return std::numeric_limits<double>::infinity();
      largest[i] = std::max(largest[i], Number(abs(gradient_[i])));
    }
  }
  Number total = 0;
  for (std::size_t i = 0; i < code_.inputs.size(); ++i) {
    const Column& column = *samples_.find(code_.inputs[i].symbol, code_.inputs[i].component);
    const std::size_t count = column.particle_stride == 0 ? 1 : samples_.particles();
    for (std::size_t particle = 0; particle < count; ++particle) {
      const double x = column.values[sample * column.sample_stride + particle * column.particle_stride];
      total += abs(Number(x)) * largest[gradient_first_[i] + particle];
    }
  }
  if (size == 0) return std::numeric_limits<double>::infinity();
  return static_cast<double>(Number(total / size));
}

}  // namespace

std::vector<double> condition_numbers(const Program& program, const Samples& samples,
                                      std::span<const std::uint32_t> at, std::size_t budget) {
  static_cast<void>(varying_inputs(program, samples, at));
  std::vector<double> result;
  if (program.outputs() == 0) return result;
  Tape tape(program, samples, at);
  for (std::size_t sample = 0; sample < samples.samples(); ++sample) {
    if ((sample + 1) * tape.work() > budget) break;
    result.push_back(tape.condition(sample));
  }
  return result;
}

}  // namespace rigor
