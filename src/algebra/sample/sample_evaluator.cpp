// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_evaluator.h"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace rigor {

void SampleDomain::step() {
  if (budget_ != nullptr) budget_->count(1);
  if (++steps_ > largest_steps_)
    throw Undecidable(fmt::format("more than {} steps of evaluation", largest_steps_));
}

PointValue SampleDomain::number(const std::string& digits) {
  const auto [known, is_new] = numbers_.try_emplace(digits);
  if (is_new) known->second = from_digits(digits);
  return known->second;
}

PointValue SampleDomain::value(SymbolId symbol, std::uint32_t particle, std::size_t component) {
  const Rational& number = point_->value(symbol, particle, component);
  const Meaning& meaning = point_->meaning(symbol);
  if (meaning.kind == Meaning::Kind::itself) return number;
  if (meaning.kind == Meaning::Kind::logarithm && !cln::plusp(number))
    throw PointRejected("a logarithm of a number that is not positive");
  PointValue value;
  value.parts.push_back({1, number, meaning, point_->place(symbol, particle) + component});
  return value;
}

namespace {

/// Numbers with more digits than these are worth no sample: each squaring doubles them.
[[nodiscard]] PointValue bounded(Rational value) {
  if (bit_size(value) > largest_bits) throw PointRejected("a number has too many digits");
  return value;
}

}  // namespace

PointValue SampleDomain::multiply(const PointValue& a, const PointValue& b) {
  if (is_rational(a) && is_rational(b)) return bounded(a.rational * b.rational);
  if (is_rational(a)) return scaled(b, a.rational);
  if (is_rational(b)) return scaled(a, b.rational);
  return PointValue(product(enclosure(a), enclosure(b)));
}

PointValue SampleDomain::divide(const PointValue& a, const PointValue& b) {
  if (!is_rational(b)) return PointValue(quotient(enclosure(a), enclosure(b)));
  if (cln::zerop(b.rational)) throw PointRejected("division by zero");
  return is_rational(a) ? bounded(a.rational / b.rational) : scaled(a, 1 / b.rational);
}

PointValue SampleDomain::power(const PointValue& base, int exponent) {
  if (exponent == 1) return base;
  if (!is_rational(base)) return PointValue(rigor::power(enclosure(base), exponent));
  const Rational& number = base.rational;
  if (exponent < 0 && cln::zerop(number)) throw PointRejected("division by zero");
  if (bit_size(number) * std::abs(exponent) > largest_bits) {
    throw PointRejected("a number has too many digits");
  }
  return power_of(number, exponent);
}

PointValue SampleDomain::exact_function(Function function, const PointValue& argument) {
  if (function == Function::exp) return exponential(argument);
  if (function == Function::sin) return cosine_and_sine(argument).sine;
  if (function == Function::cos) return cosine_and_sine(argument).cosine;
  const Rational& number = rational_of(argument);
  if (function == Function::log && number == 1) return 0;
  if (function == Function::arcsin && cln::zerop(number)) return 0;
  if (function == Function::arctan && cln::zerop(number)) return 0;
  throw PointRejected("a value of a function is not rational");
}

PointValue SampleDomain::function(Function function, const PointValue& argument) {
  try {
    return exact_function(function, argument);
  } catch (const PointRejected&) {
    if (!encloses_) throw;
    return PointValue(applied(function, enclosure(argument)));
  }
}

/// base^exponent is exp(exponent · log base).
PointValue SampleDomain::real_power(const PointValue& base, const PointValue& exponent) {
  const Rational* whole = is_rational(exponent) ? &exponent.rational : nullptr;
  if (is_rational(base) ? !cln::plusp(base.rational) : !cln::plusp(enclosure(base).low))
    throw PointRejected("a power of a number that is not positive");
  if (whole != nullptr && cln::denominator(*whole) == 1 && cln::abs(*whole) <= largest_exponent)
    return power(base, static_cast<int>(cln::double_approx(*whole)));
  return function(Function::exp, multiply(exponent, function(Function::log, base)));
}

PointValue SampleDomain::root(const PointValue& square) {
  if (is_rational(square)) {
    if (std::optional<Rational> root = exact_root(square.rational)) return *std::move(root);
  }
  return PointValue(rigor::root(enclosure(square)));
}

void SampleDomain::check_root(const PointValue& square) {
  if (cln::minusp(enclosure_of(square).high)) throw PointRejected("a root of a negative number");
}

Enclosure SampleDomain::enclosure(const PointValue& value) {
  constexpr int price = 16;  // steps
  if (!encloses_) throw PointRejected("a value is not rational");
  for (int i = 0; i < price; ++i) step();
  return enclosure_of(value);
}

PointValue SampleDomain::circle_number() const {
  if (circle_) return *circle_;
  if (!encloses_) throw PointRejected("a value is not rational");
  static const Enclosure value = rigor::circle_number();
  return PointValue(value);
}

void SampleEvaluator::look_at(const SamplePoint& point) {
  domain_.look_at(point);
  evaluator_.forget();
}

template <class Visit>
void SampleEvaluator::for_each_place(const Equation& equation, const Visit& visit) {
  std::vector<std::uint32_t> particles(equation.particles.size(), 1);
  do {
    for (std::size_t i = 0; i < particles.size(); ++i) evaluator_.bind(equation.particles[i], particles[i]);
    const auto visit_axes = [&](std::vector<std::uint8_t> axes, const PointValue& left,
                                const PointValue& right) {
      return visit(Place{std::move(axes), particles}, left, right);
    };
    if (!for_each_component(evaluator_, scope_->tree(), equation, visit_axes)) return;
  } while (next_tuple(particles, 1u, domain_.point().particles()));
}

std::optional<Difference> SampleEvaluator::difference(const Equation& equation) {
  std::optional<Difference> found;
  for_each_place(equation, [&](const Place& place, const PointValue& left, const PointValue& right) {
    if (!is_related(left, equation.relation, right)) found = Difference{place, left, right};
    return !found;
  });
  return found;
}

bool SampleEvaluator::left_vanishes(const Equation& equation) {
  bool vanishes = true;
  for_each_place(equation, [&](const Place&, const PointValue& left, const PointValue&) {
    return vanishes = domain_.is_zero(left);
  });
  return vanishes;
}

std::vector<Rational> SampleEvaluator::residuals(const Equation& equation) {
  std::vector<Rational> all;
  for_each_place(equation, [&](const Place&, const PointValue& left, const PointValue& right) {
    all.push_back(rational_of(left) - rational_of(right));
    return true;
  });
  return all;
}

Difference SampleEvaluator::at(const Equation& equation, const Place& place) {
  for (std::size_t i = 0; i < equation.particles.size(); ++i) {
    evaluator_.bind(equation.particles[i], place.particles[i]);
  }
  const std::vector<std::uint8_t> dimensions = dimensions_of(scope_->tree(), equation);
  std::size_t component = 0;
  for (std::size_t i = 0; i < place.axes.size(); ++i) {
    if (i < equation.indices.size()) {
      evaluator_.bind(equation.indices[i], place.axes[i]);
    } else {
      component = dimensions[i] * component + (place.axes[i] - 1u);
    }
  }
  return {place, evaluator_.array(equation.left)[component], evaluator_.array(equation.right)[component]};
}

std::vector<PointValue> SampleEvaluator::value_of(const Definition& definition, std::uint32_t particle) {
  return evaluator_.value_of(definition, particle);
}

std::vector<Place> SampleEvaluator::places(const Equation& equation) const {
  const std::vector<std::uint8_t> dimensions = dimensions_of(scope_->tree(), equation);
  std::vector<Place> all;
  Place place{.axes = std::vector<std::uint8_t>(dimensions.size(), 1),
              .particles = std::vector<std::uint32_t>(equation.particles.size(), 1)};
  do {
    do {
      all.push_back(place);
    } while (next_axes(place.axes, dimensions));
  } while (next_tuple(place.particles, 1u, domain_.point().particles()));
  return all;
}

}  // namespace rigor
