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

ExactValue SampleDomain::number(const std::string& digits) {
  const auto [known, is_new] = numbers_.try_emplace(digits);
  if (is_new) known->second = from_digits(digits);
  return known->second;
}

ExactValue SampleDomain::value(SymbolId symbol, std::uint32_t particle, std::size_t component) {
  const Rational& number = point_->value(symbol, particle, component);
  const Meaning& meaning = point_->meaning(symbol);
  if (meaning.kind == Meaning::Kind::itself) return number;
  if (meaning.kind == Meaning::Kind::logarithm && !cln::plusp(number))
    throw PointRejected("a logarithm of a number that is not positive");
  ExactValue value;
  value.parts.push_back({1, number, meaning, point_->place(symbol, particle) + component});
  return value;
}

namespace {

/// Numbers with more digits than these are worth no sample: each squaring doubles them.
[[nodiscard]] ExactValue bounded(Rational value) {
  if (bit_size(value) > largest_bits) throw PointRejected("a number has too many digits");
  return value;
}

}  // namespace

ExactValue SampleDomain::multiply(const ExactValue& a, const ExactValue& b) {
  if (a.parts.empty() && b.parts.empty()) return bounded(a.rational * b.rational);
  return a.parts.empty() ? scaled(b, a.rational) : scaled(a, rational_of(b));
}

ExactValue SampleDomain::divide(const ExactValue& a, const ExactValue& b) {
  const Rational& divisor = rational_of(b);
  if (cln::zerop(divisor)) throw PointRejected("division by zero");
  return a.parts.empty() ? bounded(a.rational / divisor) : scaled(a, 1 / divisor);
}

ExactValue SampleDomain::power(const ExactValue& base, int exponent) {
  if (exponent == 1) return base;
  const Rational& number = rational_of(base);
  if (exponent < 0 && cln::zerop(number)) throw PointRejected("division by zero");
  if (bit_size(number) * std::abs(exponent) > largest_bits) {
    throw PointRejected("a number has too many digits");
  }
  return power_of(number, exponent);
}

ExactValue SampleDomain::function(Function function, const ExactValue& argument) {
  if (function == Function::exp) return exponential(argument);
  const CosineAndSine both = cosine_and_sine(argument);
  return function == Function::cos ? both.cosine : both.sine;
}

ExactValue SampleDomain::root(const ExactValue& square) {
  std::optional<Rational> root = exact_root(rational_of(square));
  if (!root) throw PointRejected("a root is not rational");
  return *std::move(root);
}

void SampleDomain::check_root(const ExactValue& square) {
  if (cln::minusp(rational_of(square))) throw PointRejected("a root of a negative number");
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
    const auto visit_axes = [&](std::vector<std::uint8_t> axes, const ExactValue& left,
                                const ExactValue& right) {
      return visit(Place{std::move(axes), particles}, rational_of(left), rational_of(right));
    };
    if (!for_each_component(evaluator_, scope_->tree(), equation, visit_axes)) return;
  } while (next_tuple(particles, 1u, domain_.point().particles()));
}

std::optional<Difference> SampleEvaluator::difference(const Equation& equation) {
  std::optional<Difference> found;
  for_each_place(equation, [&](const Place& place, const Rational& left, const Rational& right) {
    if (!is_related(left, equation.relation, right)) found = Difference{place, left, right};
    return !found;
  });
  return found;
}

bool SampleEvaluator::left_vanishes(const Equation& equation) {
  bool vanishes = true;
  for_each_place(equation, [&](const Place&, const Rational& left, const Rational&) {
    return vanishes = cln::zerop(left);
  });
  return vanishes;
}

std::vector<Rational> SampleEvaluator::residuals(const Equation& equation) {
  std::vector<Rational> all;
  for_each_place(equation, [&](const Place&, const Rational& left, const Rational& right) {
    all.push_back(left - right);
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
  return {place, rational_of(evaluator_.array(equation.left)[component]),
          rational_of(evaluator_.array(equation.right)[component])};
}

std::vector<Rational> SampleEvaluator::value_of(const Definition& definition, std::uint32_t particle) {
  std::vector<Rational> components;
  for (const ExactValue& each : evaluator_.value_of(definition, particle))
    components.push_back(rational_of(each));
  return components;
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
