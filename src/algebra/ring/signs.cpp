// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/signs.h"

#include <ginac/ginac.h>

#include <array>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::array single{Sign::negative, Sign::zero, Sign::positive};
constexpr std::size_t largest_fact = 200;  // terms

[[nodiscard]] constexpr Sign either(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

[[nodiscard]] Sign sum_of_single(Sign a, Sign b) {
  if (a == Sign::zero) return b;
  return b == Sign::zero || a == b ? a : Sign::any;
}

[[nodiscard]] Sign product_of_single(Sign a, Sign b) {
  if (a == Sign::zero || b == Sign::zero) return Sign::zero;
  return a == b ? Sign::positive : Sign::negative;
}

/// The signs that an operation may have when its operands have one of theirs.
template <class Operation>
[[nodiscard]] Sign combined(Sign a, Sign b, const Operation& operation) {
  Sign result = Sign::impossible;
  for (const Sign x : single) {
    for (const Sign y : single) {
      if (is_within(x, a) && is_within(y, b)) result = either(result, operation(x, y));
    }
  }
  return result;
}

[[nodiscard]] Sign of_number(const ex& number) {
  const auto& value = GiNaC::ex_to<GiNaC::numeric>(number);
  return value.is_zero() ? Sign::zero : value.is_positive() ? Sign::positive : Sign::negative;
}

}  // namespace

Sign opposite(Sign sign) { return combined(sign, Sign::negative, product_of_single); }
Sign sum(Sign a, Sign b) { return combined(a, b, sum_of_single); }
Sign product(Sign a, Sign b) { return combined(a, b, product_of_single); }

Sign power(Sign base, int exponent) {
  if (exponent == 0) return Sign::positive;
  if (exponent < 0) base = common(base, Sign::not_zero);
  if (exponent % 2 != 0) return base;
  Sign result = is_within(Sign::zero, base) ? Sign::zero : Sign::impossible;
  if (common(base, Sign::not_zero) != Sign::impossible) result = either(result, Sign::positive);
  return result;
}

void Signs::know(const ex& indeterminate, Sign sign) {
  const Indeterminates::Origin& origin = indeterminates_.origin(indeterminate);
  const bool of_each = origin.kind == Indeterminates::Kind::coordinate && origin.frame == template_frame;
  Sign& known =
      of_each ? of_each_particle_.try_emplace({origin.symbol, origin.component}, Sign::any).first->second
              : known_.try_emplace(indeterminate, Sign::any).first->second;
  known = common(known, sign);
}

void Signs::add_fact(const ex& value, Sign sign) {
  if (GiNaC::is_a<GiNaC::numeric>(value) || term_count(value) > largest_fact) return;
  const Sign narrower = common(sign, of(value));  // a sum of squares that is not 0 is positive
  if (narrower != Sign::impossible) sign = narrower;
  for (const Fact& each : facts_) {
    if (each.value.is_equal(value) && is_within(each.sign, sign)) return;
  }
  facts_.push_back({value, sign});
}

Sign Signs::of_known(const ex& value) const {
  Sign sign = of(value);
  for (const Fact& fact : facts_) {
    if (fact.value.is_equal(value)) sign = common(sign, fact.sign);
    if (fact.value.is_equal(-value)) sign = common(sign, opposite(fact.sign));
  }
  return sign;
}

/// Of x, where the fact is x^exponent times a rest: a product that is not 0 has no factor 0, and an odd power
/// of x has the sign of the fact times that of the rest.
Sign Signs::of_factor(const Fact& fact, const ex& rest, int exponent) const {
  const bool vanishes_nowhere = is_within(fact.sign, Sign::not_zero);
  Sign of_rest = of_known(rest);
  if (vanishes_nowhere) of_rest = common(of_rest, Sign::not_zero);
  const Sign allowed = vanishes_nowhere ? Sign::not_zero : Sign::any;
  const bool says = exponent % 2 != 0 && is_surely(of_rest, Sign::not_zero);
  return says ? common(allowed, product(fact.sign, of_rest)) : allowed;
}

/// From c x + rest with the sign of the fact: c x = fact − rest.
bool Signs::conclude_from(const Fact& fact) {
  bool any = false;
  for (const ex& x : indeterminates_.all()) {
    const int degree = fact.value.degree(x);
    if (degree == 0) continue;
    const Sign before = of_indeterminate(x);
    Sign sign = before;
    const ex factor = fact.value.coeff(x, degree);
    if (fact.value.ldegree(x) == degree) sign = common(sign, of_factor(fact, factor, degree));
    if (degree == 1 && GiNaC::is_a<GiNaC::numeric>(factor)) {
      const Sign multiple = sum(fact.sign, opposite(of(fact.value.coeff(x, 0))));
      sign = common(sign, product(multiple, of_number(factor)));
    }
    if (sign == before) continue;
    if (sign == Sign::impossible) throw Contradiction();
    know(x, sign);
    any = true;
  }
  return any;
}

void Signs::conclude() {
  bool any = true;
  for (std::size_t round = 0; any && round <= facts_.size(); ++round) {
    any = false;
    for (const Fact& fact : facts_) any = conclude_from(fact) || any;
  }
}

Sign Signs::of_indeterminate(const ex& indeterminate) const {
  const Indeterminates::Origin& origin = indeterminates_.origin(indeterminate);
  const auto known = known_.find(indeterminate);
  const Sign own = known == known_.end() ? Sign::any : known->second;
  if (origin.kind != Indeterminates::Kind::coordinate || origin.frame == common_frame) return own;
  const auto each = of_each_particle_.find({origin.symbol, origin.component});
  return each == of_each_particle_.end() ? own : common(own, each->second);
}

/// Recursion: as deep as the expression.
Sign Signs::of(const ex& value) const {
  if (GiNaC::is_a<GiNaC::numeric>(value)) return of_number(value);
  if (GiNaC::is_a<GiNaC::symbol>(value)) return of_indeterminate(value);
  if (GiNaC::is_a<GiNaC::power>(value)) {
    return power(of(value.op(0)), GiNaC::ex_to<GiNaC::numeric>(value.op(1)).to_int());
  }
  const bool sums = GiNaC::is_a<GiNaC::add>(value);
  Sign result = sums ? Sign::zero : Sign::positive;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    result = sums ? sum(result, of(value.op(i))) : product(result, of(value.op(i)));
  }
  return result;
}

Sign Signs::of(const Fraction& value) const {
  Sign result = of(value.numerator);
  for (const Divisor& each : value.divisors) result = product(result, power(of(each.base), -each.exponent));
  return result;
}

}  // namespace rigor
