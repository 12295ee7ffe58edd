// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/radicals.h"

#include <cln/integer.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "algebra/engine/budget.h"
#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/ring/division.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr long largest_trial_divisor = 1000;
constexpr const char* one_is_negative = "roots of which one is of a negative number";
constexpr std::size_t largest_part = 8;           // terms
constexpr std::size_t largest_quotient = 20'000;  // takes up to 50 ms

[[nodiscard]] Rational to_rational(const ex& value) {
  return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
}

/// n = square² · rest, with the square factors of small primes, or of all of n, taken out.
struct SquareSplit {
  cln::cl_I square = 1;
  cln::cl_I rest;
};

[[nodiscard]] SquareSplit split_squares(cln::cl_I n) {
  SquareSplit split;
  for (long p = 2; p <= largest_trial_divisor; ++p) {
    const cln::cl_I square = cln::cl_I(p) * p;
    if (square > n) break;
    while (cln::zerop(cln::mod(n, square))) {
      n = cln::exquo(n, square);
      split.square = split.square * p;
    }
  }
  cln::cl_I whole;
  if (cln::sqrtp(n, &whole)) {
    split.square = split.square * whole;
    n = 1;
  }
  split.rest = n;
  return split;
}

}  // namespace

bool Radicals::is_radical(const ex& indeterminate) const {
  return GiNaC::is_a<GiNaC::symbol>(indeterminate) &&
         indeterminates_.origin(indeterminate).kind == Indeterminates::Kind::radical;
}

/// By the signs of its terms, or as a multiple of something whose sign is known.
Sign Radicals::sign_of(const ex& expanded) const {
  const Sign direct = signs_.of(expanded);
  if (direct != Sign::any) return direct;
  for (const Signs::Fact& fact : signs_.facts()) {
    ex quotient;
    const bool is_multiple = term_count(fact.value) == term_count(expanded) &&
                             size_of_division(fact.value, expanded) <= largest_quotient &&
                             divides(fact.value, expanded, quotient, arithmetic_.budget());
    if (!is_multiple) continue;
    if (is_number(quotient)) return product(fact.sign, signs_.of(quotient));
  }
  return Sign::any;
}

void Radicals::note(std::vector<Factor>& found, const ex& base, int exponent) {
  for (Factor& each : found) {
    if (!each.base.is_equal(base)) continue;
    each.exponent += exponent;
    return;
  }
  found.push_back({base, exponent});
}

/// Splits an expanded polynomial: off go common indeterminates, divisors that are known, what is known not to
/// be negative, and, if asked for, repeated factors.
void Radicals::note_factors(std::vector<Factor>& found, ex value, int exponent,
                            const std::vector<Divisor>& known) {
  if (GiNaC::is_a<GiNaC::add>(value)) {
    ex common = 1;
    for (const ex& factor : factors_of(value.op(0))) {
      const ex base = split_power(factor).first;
      if (!is_number(base)) common *= GiNaC::pow(base, value.ldegree(base));
    }
    if (!common.is_equal(1)) {
      note_factors(found, common, exponent, known);
      value = (value / common).expand();
    }
    ex quotient;
    const auto is_multiple_of = [&](const ex& base) {
      if (GiNaC::is_a<GiNaC::symbol>(base) || size_of_division(base, value) > largest_quotient) return false;
      return divides(base, value, quotient, arithmetic_.budget());
    };
    const auto split_off = [&](const ex& base) {
      while (is_multiple_of(base)) {
        note(found, base, exponent);
        value = quotient;
      }
    };
    for (const Divisor& each : known) split_off(each.base);
    for (const Signs::Fact& fact : signs_.facts()) {  // √(x² - y²) beside √(x - y)
      const bool part = GiNaC::is_a<GiNaC::add>(fact.value) && term_count(fact.value) < largest_part &&
                        !fact.value.is_equal(value) && !fact.value.is_equal(-value);
      if (part && is_within(fact.sign, Sign::not_negative)) split_off(fact.value);
    }
    if (effort_ == Effort::factored && may_be_factored(value)) {
      value = with_repeated_factors(value, arithmetic_.budget());
    }
  }
  for (const ex& factor : factors_of(value)) {
    const auto [base, power] = split_power(factor);
    note(found, base.expand(), power * exponent);
  }
}

std::vector<Radicals::Factor> Radicals::factors(const Fraction& value) {
  std::vector<Factor> found;
  for (const ex& factor : factors_of(value.numerator)) {
    const auto [base, exponent] = split_power(factor);
    if (is_number(base)) {  // GiNaC may have put it there, or not: it counts nothing
      note(found, base, exponent);
      continue;
    }
    note_factors(found, reduced(arithmetic_.expanded(base, value.terms)), exponent, value.divisors);
  }
  for (const Divisor& each : value.divisors) note(found, each.base, -each.exponent);
  // GiNaC's order, and the signs of what it takes apart, differ from run to run.
  std::map<std::string, Factor> ordered;
  bool turned = false;
  for (Factor& each : found) {
    Indeterminates::Unsigned fingerprint = indeterminates_.unsigned_fingerprint(each.base);
    if (fingerprint.negative) {
      each.base = (-each.base).expand();
      if (each.exponent % 2 != 0) turned = !turned;
    }
    const auto [at, is_new] = ordered.try_emplace(std::move(fingerprint.text), each);
    if (!is_new) at->second.exponent += each.exponent;
  }
  found.clear();
  if (turned) found.push_back({-1, 1});
  for (auto& [fingerprint, factor] : ordered) found.push_back(std::move(factor));
  return found;
}

/// Where √(f² g) has a value and f is not 0, g is not negative; where f may be 0, nothing is known of g. An
/// odd power of u has the sign of u.
void Radicals::note_existence(const std::vector<Factor>& square) {
  bool turned = false;  // by what is known to be negative
  std::vector<ex> of_unknown_sign;
  for (const Factor& factor : square) {
    const bool odd = factor.exponent % 2 != 0;
    const Sign sign = sign_of(factor.base);
    const bool known = is_within(sign, Sign::positive) || is_within(sign, Sign::negative);
    if (odd && !known) {
      of_unknown_sign.push_back(factor.base);
    } else if (factor.exponent > 0 && !is_within(sign, Sign::not_zero)) {
      return;
    }
    if (odd && is_within(sign, Sign::negative)) turned = !turned;
  }
  ex remaining = turned ? -1 : 1;
  for (const ex& each : of_unknown_sign) remaining *= each;
  remaining = remaining.expand();
  if (is_number(remaining) || never_negative(remaining)) return;
  for (const Signs::Fact& fact : signs_.facts()) {  // √(x - 2) beside √(1 - x)
    const ex sum = (fact.value + remaining).expand();
    if (is_surely(fact.sign, Sign::not_negative) && is_number(sum) &&
        is_surely(signs_.of(sum), Sign::negative))
      throw NoRealValue(one_is_negative);
  }
  signs_.add_fact(remaining, Sign::not_negative);
  // uw ≥ 0 and u + w > 0: both are not negative.
  if (of_unknown_sign.size() == 2 && !turned) {
    const Sign of_sum = signs_.of((of_unknown_sign[0] + of_unknown_sign[1]).expand());
    for (const ex& each : of_unknown_sign) {
      if (is_surely(of_sum, Sign::positive)) signs_.add_fact(each, Sign::not_negative);
      if (is_surely(of_sum, Sign::negative)) signs_.add_fact((-each).expand(), Sign::not_negative);
    }
  }
  try {
    signs_.conclude();
  } catch (const Contradiction&) {
    throw NoRealValue(one_is_negative);
  }
}

Fraction Radicals::root(const Fraction& square) {
  if (square.numerator.is_zero()) return {};
  Fraction result = to_fraction(1);
  Rational number = 1;
  ex rest = 1;          // what has to stay under one root
  bool nonzero = true;  // no factor is zero at any values
  const auto times = [&](const Fraction& factor) { result = arithmetic_.multiply(result, factor); };
  const std::vector<Factor> all = factors(square);
  note_existence(all);
  for (const Factor& factor : all) {
    if (is_number(factor.base)) {
      number = number * power_of(to_rational(factor.base), factor.exponent);
      continue;
    }
    if (factor.exponent == 0) continue;
    const GiNaC::numeric content = factor.base.integer_content();
    number = number * power_of(to_rational(content), factor.exponent);
    ex base = (factor.base / content).expand();
    const Sign sign = sign_of(base);
    nonzero = nonzero && is_within(sign, Sign::not_zero);
    if (is_within(sign, Sign::not_positive)) {
      base = (-base).expand();
      if (factor.exponent % 2 != 0) number = -number;
    }
    const bool odd = factor.exponent % 2 != 0;
    const int half = (factor.exponent - (odd ? 1 : 0)) / 2;
    const bool positive = never_negative(base);
    if (half != 0)
      times(arithmetic_.power(positive || half % 2 == 0 ? polynomial(base) : absolute(base), half));
    if (odd && positive) times(radical(base));
    if (odd && !positive) rest *= base;
  }
  if (rest.is_equal(1)) {
    if (cln::minusp(number) && nonzero) throw NoRealValue("a root of a negative number");
    times(root_of_number(number));
  } else {
    if (cln::minusp(number)) rest = -rest;
    times(root_of_number(cln::abs(number)));
    times(radical(reduced(arithmetic_.expanded(rest, square.terms))));
  }
  rationalize(result);
  return result;
}

Fraction Radicals::root_of_number(const Rational& value) {
  if (cln::minusp(value)) throw Undecidable("a root of a negative number");
  const cln::cl_I denominator = cln::denominator(value);
  const SquareSplit split = split_squares(cln::numerator(value) * denominator);
  Fraction result = to_fraction(Rational(split.square) / denominator);
  if (split.rest == 1) return result;
  return arithmetic_.multiply(result, radical(GiNaC::numeric(split.rest)));
}

Fraction Radicals::absolute(const ex& value) {
  if (never_negative((-value).expand())) return polynomial((-value).expand());
  return radical(reduced(
      arithmetic_.expanded(value * value, static_cast<double>(term_count(value) * term_count(value)))));
}

std::vector<std::pair<ex, ex>> Radicals::roots() const {
  std::vector<std::pair<ex, ex>> all;
  for (const Radical& each : radicals_) {
    if (each.root) all.emplace_back(each.symbol, each.square.written());
  }
  return all;
}

std::vector<std::pair<ex, ex>> Radicals::relations() const {
  std::vector<std::pair<ex, ex>> all;
  for (const Radical& each : radicals_) all.emplace_back(each.symbol, each.square.written());
  return all;
}

Fraction Radicals::radical(const ex& square) {
  for (const Radical& known : radicals_) {
    if (known.root && known.square.written().is_equal(square)) return polynomial(known.symbol);
  }
  const ex symbol = indeterminates_.fresh(Indeterminates::Kind::radical, indeterminates_.frames_of(square));
  radicals_.push_back({symbol, square});
  any_root_ = true;
  signs_.know(symbol, is_within(sign_of(square), Sign::positive) ? Sign::positive : Sign::not_negative);
  return polynomial(symbol);
}

void Radicals::relate(const ex& symbol, const ex& square) {
  const bool known =
      std::ranges::any_of(radicals_, [&](const Radical& each) { return each.symbol.is_equal(symbol); });
  if (!known) radicals_.push_back({symbol, Numerator(square.expand()), false});
}

Numerator Radicals::reduced(const Numerator& expanded) {
  if (radicals_.empty()) return expanded;
  const PackedLetters& letters = indeterminates_.letters();
  Numerator value = expanded;
  arithmetic_.count(static_cast<double>(arithmetic_.term_count(expanded) * radicals_.size()));
  for (std::size_t i = radicals_.size(); i-- > 0;) {
    const Radical each = radicals_[i];
    arithmetic_.count(price::looked_at_term * static_cast<double>(arithmetic_.term_count(value)));
    const PackedPolynomial* const packed = value.packed(letters);
    if (packed == nullptr) {  // its degree is very high
      value = value.written().subs(GiNaC::pow(each.symbol, 2) == each.square.written(),
                                   GiNaC::subs_options::algebraic);
      value = value.written().expand();
      continue;
    }
    const std::size_t letter = letters.position(each.symbol);
    const int degree = packed->degree_in(letter);
    if (degree < 2) continue;
    double terms = 0;
    Numerator sum;
    for (int power = 0; power <= degree; ++power) {
      PackedPolynomial coefficient = packed->coefficient_of(letter, power);
      if (coefficient.is_zero()) continue;
      const auto count = static_cast<double>(coefficient.size());
      Numerator part(std::move(coefficient), letters);
      if (power % 2 != 0) part = part.times(each.symbol, letters);
      if (power >= 2) {
        const Fraction factor = arithmetic_.power(polynomial(each.square), power / 2);
        part = part.times(factor.numerator, letters);
        terms += factor.terms * count;
      } else {
        terms += count;
      }
      sum.add(part, letters);
    }
    value = arithmetic_.expanded(sum, terms);
  }
  return value;
}

void Radicals::rationalize(Fraction& value) {
  for (std::size_t i = 0; i < value.divisors.size(); ++i) {
    const Divisor divisor = value.divisors[i];
    if (!is_radical(divisor.base)) continue;
    value.divisors.erase(value.divisors.begin() + static_cast<std::ptrdiff_t>(i--));
    const auto known =
        std::ranges::find_if(radicals_, [&](const Radical& r) { return r.symbol.is_equal(divisor.base); });
    Fraction inverse =
        arithmetic_.power(arithmetic_.reciprocal(polynomial(known->square)), (divisor.exponent + 1) / 2);
    if (divisor.exponent % 2 != 0) inverse = arithmetic_.multiply(inverse, polynomial(divisor.base));
    value = arithmetic_.multiply(value, inverse);
  }
}

ex Radicals::squared(const ex& equation) {
  const Radical* only = nullptr;
  for (const Radical& each : radicals_) {
    if (equation.degree(each.symbol) == 0) continue;
    if (only != nullptr) return 0;
    only = &each;
  }
  if (only == nullptr) return 0;
  const ex a = equation.coeff(only->symbol, 1);
  const ex b = equation.coeff(only->symbol, 0);
  const double terms_of_a = std::pow(static_cast<double>(term_count(a)), 2);
  const double terms_of_b = std::pow(static_cast<double>(term_count(b)), 2);
  const double terms = terms_of_b + terms_of_a * static_cast<double>(term_count(only->square.written()));
  return reduced(arithmetic_.expanded(b * b - a * a * only->square.written(), terms));
}

ex Radicals::moved(const ex& value, Frame from, Frame to) {
  if (from == to) return value;
  GiNaC::exmap map = indeterminates_.twins(from, to);
  const std::size_t present = radicals_.size();
  for (std::size_t i = 0; i < present; ++i) {
    const Radical each = radicals_[i];
    if ((indeterminates_.frames_of(each.square) & only(from)) == 0) continue;
    const ex square = each.square.written().subs(map, GiNaC::subs_options::no_pattern);
    const auto twin = map.find(each.symbol);
    if (each.root) {
      map.emplace(each.symbol, radical(square).numerator);
    } else if (twin != map.end()) {
      relate(twin->second, square);
    }
  }
  return value.subs(map, GiNaC::subs_options::no_pattern);
}

}  // namespace rigor
