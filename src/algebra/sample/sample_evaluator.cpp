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
  if (meaning.kind == Meaning::Kind::logarithm && !cln::plusp(number)) return rejected();
  PointValue value;
  value.parts.push_back({1, number, meaning, point_->place(symbol, particle) + component});
  return value;
}

/// Numbers with more digits than these are worth no sample: each squaring doubles them.
PointValue SampleDomain::bounded(Rational value) {
  return bit_size(value) > largest_bits ? rejected() : PointValue(std::move(value));
}

template <class Bounds>
PointValue SampleDomain::enclosed(const Bounds& bounds) {
  if (!encloses_ || rejected_) return rejected();
  try {
    return PointValue(bounds());
  } catch (const PointRejected&) {
    return rejected();
  }
}

PointValue SampleDomain::multiply(const PointValue& a, const PointValue& b) {
  if (is_rational(a) && is_rational(b)) return bounded(a.rational * b.rational);
  if (is_rational(a)) return scaled(b, a.rational);
  if (is_rational(b)) return scaled(a, b.rational);
  return enclosed([&] { return product(enclosure(a), enclosure(b)); });
}

PointValue SampleDomain::divide(const PointValue& a, const PointValue& b) {
  if (!is_rational(b)) return enclosed([&] { return quotient(enclosure(a), enclosure(b)); });
  if (cln::zerop(b.rational)) return rejected();
  return is_rational(a) ? bounded(a.rational / b.rational) : scaled(a, 1 / b.rational);
}

PointValue SampleDomain::power(const PointValue& base, int exponent) {
  if (exponent == 1) return base;
  if (!is_rational(base)) return enclosed([&] { return rigor::power(enclosure(base), exponent); });
  const Rational& number = base.rational;
  const bool divides_by_zero = exponent < 0 && cln::zerop(number);
  if (divides_by_zero || bit_size(number) * std::abs(exponent) > largest_bits) return rejected();
  return power_of(number, exponent);
}

namespace {

/// Nothing where the value is not rational.
[[nodiscard]] std::optional<Rational> exact_function(Function function, const PointValue& argument) {
  if (function == Function::exp) return exponential(argument);
  if (function == Function::sin || function == Function::cos) {
    auto both = cosine_and_sine(argument);
    if (!both) return std::nullopt;
    return function == Function::sin ? std::move(both->sine) : std::move(both->cosine);
  }
  if (!is_rational(argument)) return std::nullopt;
  const Rational& number = argument.rational;
  if (function == Function::log && number == 1) return 0;
  if (function == Function::arcsin && cln::zerop(number)) return 0;
  if (function == Function::arctan && cln::zerop(number)) return 0;
  return std::nullopt;
}

}  // namespace

PointValue SampleDomain::function(Function function, const PointValue& argument) {
  if (auto exact = exact_function(function, argument)) return *std::move(exact);
  return enclosed([&] { return applied(function, enclosure(argument)); });
}

/// base^exponent is exp(exponent · log base).
PointValue SampleDomain::real_power(const PointValue& base, const PointValue& exponent) {
  const Rational* whole = is_rational(exponent) ? &exponent.rational : nullptr;
  if (is_rational(base) ? !cln::plusp(base.rational) : !is_enclosed_above_zero(base)) return rejected();
  if (whole != nullptr && cln::denominator(*whole) == 1 && cln::abs(*whole) <= largest_exponent)
    return power(base, static_cast<int>(cln::double_approx(*whole)));
  return function(Function::exp, multiply(exponent, function(Function::log, base)));
}

bool SampleDomain::is_enclosed_above_zero(const PointValue& value) {
  const PointValue bounds = enclosed([&] { return enclosure(value); });
  return !rejected_ && cln::plusp(bounds.enclosed->low);
}

PointValue SampleDomain::root(const PointValue& square) {
  if (is_rational(square)) {
    if (std::optional<Rational> root = exact_root(square.rational)) return *std::move(root);
  }
  return enclosed([&] { return rigor::root(enclosure(square)); });
}

void SampleDomain::check_root(const PointValue& square) {
  rejected_ = rejected_ || cln::minusp(enclosure_of(square).high);
}

Enclosure SampleDomain::enclosure(const PointValue& value) {
  constexpr int price = 16;  // steps
  for (int i = 0; i < price; ++i) step();
  return enclosure_of(value);
}

PointValue SampleDomain::circle_number() {
  if (circle_) return *circle_;
  return enclosed([] {
    static const Enclosure value = rigor::circle_number();
    return value;
  });
}

void SampleEvaluator::look_at(const SamplePoint& point) {
  domain_.look_at(point);
  evaluator_.forget();
}

void SampleEvaluator::throw_if_rejected() const {
  if (domain_.is_rejected()) throw PointRejected("a value is not defined, or not rational");
}

template <class Visit>
void SampleEvaluator::for_each_place(const Equation& equation, const Visit& visit) {
  std::vector<std::uint32_t> particles(equation.particles.size(), 1);
  domain_.begin();
  do {
    for (std::size_t i = 0; i < particles.size(); ++i) evaluator_.bind(equation.particles[i], particles[i]);
    const auto visit_axes = [&](std::vector<std::uint8_t> axes, const PointValue& left,
                                const PointValue& right) {
      throw_if_rejected();
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
  domain_.begin();
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
  Difference sides{place, evaluator_.array(equation.left)[component],
                   evaluator_.array(equation.right)[component]};
  throw_if_rejected();
  return sides;
}

std::vector<PointValue> SampleEvaluator::value_of(const Definition& definition, std::uint32_t particle) {
  domain_.begin();
  std::vector<PointValue> value = evaluator_.value_of(definition, particle);
  throw_if_rejected();
  return value;
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
