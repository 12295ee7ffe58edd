// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/condition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "numeric/measure/measure.h"
#include "numeric/measure/reference_exact.h"
#include "numeric/run/run_bounded_decimal.h"
#include "numeric/run/run_samples.h"

namespace rigor {
namespace {

constexpr int bits_of_condition = 20;  // of a condition number
constexpr int bits_that_matter = 60;   // below 2^-60 a condition number multiplies an error by nothing

/// |y| where that is larger than |x|, with a bound that holds for either.
template <class Number>
void enlarge(Number& x, const Number& y) {
  const bool undefined = x.undefined || y.undefined;
  const Magnitude bound = std::max(x.bound, y.bound);
  if (x.value < abs(y.value)) x.value = abs(y.value);
  x.bound = bound;
  x.undefined = undefined;
}

/// All values of a program at one sample, for all particles of the loops that they are in, and how a result
/// depends on each.
template <class Number>
class Tape {
 public:
  Tape(const Program& program, const Samples& samples, std::span<const std::uint32_t> at)
      : program_(program), code_(program.code()), samples_(samples), at_(at) {
    first_.reserve(code_.values.size());
    for (const Value& value : code_.values) {
      first_.push_back(elements_);
      elements_ += tuples(value.levels);
    }
    for (const ProgramInput& input : program.inputs()) {
      const Column& column = *samples.find(input.symbol, input.component);
      gradient_first_.push_back(gradient_count_);
      gradient_count_ += column.particle_stride == 0 ? 1 : samples.particles();
    }
  }

  /// Nothing where so many digits do not tell.
  [[nodiscard]] std::optional<double> condition(std::size_t sample) {
    run(sample);
    Number size;
    std::vector<Number> largest(gradient_count_);  // over the results
    for (const ValueId output : code_.outputs) {
      const Number& result = value_[first_[output]];
      if (result.undefined) return std::numeric_limits<double>::quiet_NaN();
      enlarge(size, result);
      differentiate(output);
      for (std::size_t i = 0; i < gradient_count_; ++i) enlarge(largest[i], gradient_[i]);
    }
    Number total;
    for (std::size_t i = 0; i < code_.inputs.size(); ++i) {
      const Column& column = *samples_.find(code_.inputs[i].symbol, code_.inputs[i].component);
      const std::size_t count = column.particle_stride == 0 ? 1 : samples_.particles();
      for (std::size_t particle = 0; particle < count; ++particle) {
        const double x = column.values[sample * column.sample_stride + particle * column.particle_stride];
        total = total + Number(std::abs(x)) * largest[gradient_first_[i] + particle];
      }
    }
    if (total.undefined || size.is_exact_zero()) return std::numeric_limits<double>::infinity();
    const Number condition = total / size;
    if (condition.size() + condition.bound < Magnitude(1.0, -bits_that_matter)) return 0.0;
    if (!condition.is_exact_zero() && !condition.is_known_to(bits_of_condition)) return std::nullopt;
    return static_cast<double>(condition.value);
  }

 private:
  using Tuple = std::array<std::size_t, deepest_level + 1>;

  [[nodiscard]] std::size_t tuples(unsigned levels) const { return tuples_of(levels, samples_.particles()); }
  /// Calls visit(particles, k) for all particles of the levels.
  template <class Visit>
  void for_each(unsigned levels, const Visit& visit) const {
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

  [[nodiscard]] std::size_t element(ValueId id, const Tuple& particles) const {
    std::size_t at = 0;
    std::size_t scale = 1;
    for (std::size_t level = 1; level <= deepest_level; ++level) {
      if ((code_.values[id].levels >> level & 1u) == 0) continue;
      at += scale * particles[level];
      scale *= samples_.particles();
    }
    return first_[id] + at;
  }

  [[nodiscard]] std::size_t particle_of(const Value& input, const Tuple& particles) const {
    if (input.b == InputParticle::none) return 0;
    return input.b >= InputParticle::first_free ? at_[input.b - InputParticle::first_free]
                                                : particles[input.b];
  }

  [[nodiscard]] Number input(const Value& value, const Tuple& particles, std::size_t sample) const {
    const ProgramInput& named = code_.inputs[value.a];
    const Column& column = *samples_.find(named.symbol, named.component);
    return Number(column.values[sample * column.sample_stride +
                                particle_of(value, particles) * column.particle_stride]);
  }

  void run(std::size_t sample) {
    value_.assign(elements_, Number());
    for (ValueId id = 0; id < code_.values.size(); ++id) {
      const Value& value = code_.values[id];
      if (value.op == Instruction::sum) {
        const unsigned levels = code_.values[value.a].levels | 1u << value.level;
        for_each(levels, [&](const Tuple& particles) {
          Number& sum = value_[element(id, particles)];
          sum = sum + value_[element(value.a, particles)];
        });
      } else {
        for_each(value.levels, [&](const Tuple& particles) {
          value_[element(id, particles)] = compute(value, particles, sample);
        });
      }
    }
  }

  [[nodiscard]] Number compute(const Value& value, const Tuple& particles, std::size_t sample) const {
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
      case Instruction::tan:
        return Traits::tangent(a());
      case Instruction::sinh:
        return Traits::hyperbolic_sine(a());
      case Instruction::cosh:
        return Traits::hyperbolic_cosine(a());
      case Instruction::tanh:
        return Traits::hyperbolic_tangent(a());
      case Instruction::sum:
        break;
    }
    return {};
  }

  void differentiate(ValueId output) {
    adjoint_.assign(elements_, Number());
    gradient_.assign(gradient_count_, Number());
    adjoint_[first_[output]] = Number(1.0);
    for (ValueId id = output + 1; id-- > 0;) {
      const Value& value = code_.values[id];
      const unsigned levels =
          value.op == Instruction::sum ? code_.values[value.a].levels | 1u << value.level : value.levels;
      for_each(levels, [&](const Tuple& particles) { pass_on(id, particles); });
    }
  }

  /// Adds to its operands' adjoints what comes through one value.
  void pass_on(ValueId id, const Tuple& particles) {
    const Value& value = code_.values[id];
    const Number& here = adjoint_[element(id, particles)];
    if (here.is_exact_zero()) return;
    if (value.op == Instruction::input) {
      const ProgramInput& named = code_.inputs[value.a];
      const bool each = samples_.find(named.symbol, named.component)->particle_stride != 0;
      Number& gradient = gradient_[gradient_first_[value.a] + (each ? particle_of(value, particles) : 0)];
      gradient = gradient + here;
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
        adjoint_[at_b] = adjoint_[at_b] + here;
        break;
      case Instruction::subtract:
        adjoint_[at_b] = adjoint_[at_b] - here;
        break;
      case Instruction::multiply:
        adjoint_[at_b] = adjoint_[at_b] + here * a;
        to_a = here * b;
        break;
      case Instruction::divide:
        adjoint_[at_b] = adjoint_[at_b] - here * result / b;
        to_a = here / b;
        break;
      case Instruction::negate:
        to_a = -here;
        break;
      case Instruction::root:
        to_a = here / (result + result);
        break;
      case Instruction::absolute:
        if (a.value < 0) to_a = -here;
        if (!a.has_known_sign()) to_a.bound = Magnitude::infinite();
        break;
      case Instruction::sin:
        to_a = here * NumberTraits<Number>::cosine(a);
        break;
      case Instruction::cos:
        to_a = here * -NumberTraits<Number>::sine(a);
        break;
      case Instruction::exp:
        to_a = here * result;
        break;
      case Instruction::tan:
        to_a = here * (Number(1.0) + result * result);
        break;
      case Instruction::sinh:
        to_a = here * NumberTraits<Number>::hyperbolic_cosine(a);
        break;
      case Instruction::cosh:
        to_a = here * NumberTraits<Number>::hyperbolic_sine(a);
        break;
      case Instruction::tanh: {
        const Number cosh = NumberTraits<Number>::hyperbolic_cosine(a);
        to_a = here / (cosh * cosh);
        break;
      }
      case Instruction::sum:
      case Instruction::constant:
      case Instruction::input:
        break;
    }
    adjoint_[at_a] = adjoint_[at_a] + to_a;
  }

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
};

/// What an operation costs with so many digits, in products of numbers of 100 digits.
struct Cost {
  std::size_t operation = 1;
  std::size_t function = 1;
};
constexpr Cost with_100_digits{};  // functions cost 200, and are few
constexpr Cost with_400_digits{8, 4'000};
constexpr Cost with_1400_digits{64, 120'000};

/// How often all results can be computed and differentiated.
std::size_t affordable(const Program& program, const Samples& samples, std::size_t budget, Cost cost) {
  return budget / (1 + program.outputs()) / work_of(program, samples, cost.operation, cost.function);
}

/// Where 100 digits do not tell: with more, as long as the budget lasts, unless the result is 0.
class FurtherDigits {
 public:
  FurtherDigits(const Program& program, const Samples& samples, std::span<const std::uint32_t> at,
                std::size_t budget)
      : program_(program),
        samples_(samples),
        at_(at),
        with_400_(affordable(program, samples, budget, with_400_digits)),
        with_1400_(affordable(program, samples, budget, with_1400_digits)) {}

  [[nodiscard]] std::optional<double> condition(std::size_t sample) {
    const ReferenceDigits exact = exact_results(program_, samples_.only(std::array{sample}), at_);
    const auto is_zero = [](Known known) { return known == Known::zero; };
    if (std::ranges::all_of(exact.known, is_zero)) return std::numeric_limits<double>::infinity();
    auto condition = with<400>(sample, with_400_);
    return condition ? condition : with<1400>(sample, with_1400_);
  }

 private:
  template <unsigned digits>
  [[nodiscard]] std::optional<double> with(std::size_t sample, std::size_t& left) const {
    if (left == 0) return std::nullopt;
    --left;
    return Tape<BoundedDecimal<digits>>(program_, samples_, at_).condition(sample);
  }

  const Program& program_;
  const Samples& samples_;
  std::span<const std::uint32_t> at_;
  std::size_t with_400_;
  std::size_t with_1400_;
};

}  // namespace

std::vector<double> condition_numbers(const Program& program, const Samples& samples,
                                      std::span<const std::uint32_t> at, std::size_t budget) {
  static_cast<void>(varying_inputs(program, samples, at));
  std::vector<double> result;
  if (program.outputs() == 0) return result;
  const std::size_t most = affordable(program, samples, budget, with_100_digits);
  if (most == 0) return result;
  FurtherDigits further(program, samples, at, budget);
  Tape<BoundedDecimal<100>> tape(program, samples, at);
  for (std::size_t sample = 0; sample < std::min(samples.samples(), most); ++sample) {
    std::optional<double> condition = tape.condition(sample);
    if (!condition) condition = further.condition(sample);
    result.push_back(condition.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return result;
}

}  // namespace rigor
