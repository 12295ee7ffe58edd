// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/order.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "algebra/engine/terms.h"
#include "algebra/ring/division.h"

namespace rigor {
namespace {

using GiNaC::ex;
using Fact = Signs::Fact;

constexpr int largest_attempts = 200;
constexpr int largest_depth_of_facts = 3;
constexpr int largest_depth_of_squares = 4;
constexpr int largest_depth_of_roots = 2;
constexpr std::size_t largest_root_sum = 20;    // terms
constexpr std::size_t largest_factored = 12;    // terms
constexpr int largest_degree_factored = 6;      // in one indeterminate
constexpr std::size_t largest_quadratic = 150;  // terms
constexpr double largest_ordered = 4000;        // terms, by the estimate

[[nodiscard]] bool is_positive(const ex& value) {
  return is_number(value) && GiNaC::ex_to<GiNaC::numeric>(value).is_positive();
}

/// The positive numbers, in rising order, that a fact may be multiplied by so that a term cancels; with signs
/// given, a term of unknown sign.
[[nodiscard]] std::vector<GiNaC::numeric> multiples(const ex& value, const ex& fact, const Signs* signs) {
  std::map<ex, ex, GiNaC::ex_is_less> coefficients;
  for (const ex& term : terms_of(value)) {
    const ex coefficient = coefficient_of(term);
    coefficients.emplace(term / coefficient, coefficient);
  }
  std::vector<GiNaC::numeric> found;
  for (const ex& term : terms_of(fact)) {
    const ex coefficient = coefficient_of(term);
    const ex monomial = term / coefficient;
    const auto at = coefficients.find(monomial);
    if (at == coefficients.end()) continue;
    if (signs != nullptr && is_within(signs->of(at->second * monomial), Sign::not_negative)) continue;
    const ex ratio = at->second / coefficient;
    if (is_positive(ratio)) found.push_back(GiNaC::ex_to<GiNaC::numeric>(ratio));
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

[[nodiscard]] GiNaC::exset letters_of(const ex& value) {
  GiNaC::exset letters;
  for (const ex& term : terms_of(value)) {
    for (const ex& factor : factors_of(term)) {
      const ex base = GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
      if (!is_number(base)) letters.insert(base);
    }
  }
  return letters;
}

}  // namespace

/// The signs of the terms, and of what is left when facts are subtracted. Only ever narrower than `any` for
/// values that are not negative.
Sign Order::by_facts(const ex& value, const std::vector<Fact>& facts, int depth) {
  const Sign direct = domain_.signs().of(value);
  if (direct == Sign::not_negative && depth == 0) return by_positive_facts(value, facts);
  if (direct != Sign::any || depth == largest_depth_of_facts) return direct;
  for (const Fact& fact : facts) {
    if (!is_surely(fact.sign, Sign::not_negative)) continue;
    for (const GiNaC::numeric& multiple : multiples(value, fact.value, &domain_.signs())) {
      if (++attempts_ > largest_attempts) return Sign::any;
      domain_.count(static_cast<double>(term_count(value) + term_count(fact.value)));
      const Sign rest = by_facts((value - multiple * fact.value).expand(), facts, depth + 1);
      if (is_surely(rest, Sign::not_negative)) return sum(rest, fact.sign);
    }
  }
  return Sign::any;
}

/// What is not negative is positive if it is a multiple of a positive fact and a rest that is not negative.
Sign Order::by_positive_facts(const ex& value, const std::vector<Fact>& facts) {
  for (const Fact& fact : facts) {
    if (!is_surely(fact.sign, Sign::positive)) continue;
    for (const GiNaC::numeric& multiple : multiples(value, fact.value, nullptr)) {
      if (++attempts_ > largest_attempts) return Sign::not_negative;
      const ex rest = (value - multiple * fact.value).expand();
      if (is_surely(domain_.signs().of(rest), Sign::not_negative)) return Sign::positive;
    }
  }
  return Sign::not_negative;
}

Sign Order::by_squares(const ex& value, int depth) {
  const Sign direct = domain_.signs().of(value);
  if (direct != Sign::any || depth == largest_depth_of_squares) return direct;
  if (term_count(value) > largest_quadratic) return Sign::any;
  const std::vector<ex> all = domain_.indeterminates().all();
  for (const ex& x : all) {
    if (value.degree(x) != 2) continue;
    if (++attempts_ > largest_attempts) return Sign::any;
    const ex p = value.coeff(x, 2);
    const Sign of_p = by_squares(p, depth + 1);
    if (!is_surely(of_p, Sign::not_negative)) continue;
    const ex q = value.coeff(x, 1) / 2;
    const ex r = value.coeff(x, 0);
    const auto terms = static_cast<double>(term_count(p) * term_count(r) + term_count(q) * term_count(q));
    if (terms > largest_ordered) continue;
    const Sign of_rest = by_squares((p * r - q * q).expand(), depth + 1);
    if (!is_surely(of_rest, Sign::not_negative)) continue;
    if (of_p != Sign::positive && !is_surely(by_squares(r, depth + 1), Sign::not_negative)) continue;
    return of_p == Sign::positive && of_rest == Sign::positive ? Sign::positive : Sign::not_negative;
  }
  return Sign::any;
}

/// Solves the first fact that bounds an indeterminate for it; false if there is none. With any_bound, also
/// where the bound itself may be negative.
bool Order::parametrize(ex& value, std::vector<Fact>& facts, bool any_bound) {
  const std::vector<ex> all = domain_.indeterminates().all();
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const Fact fact = facts[i];
    if (!is_surely(fact.sign, Sign::not_negative) || !GiNaC::is_a<GiNaC::add>(fact.value)) continue;
    for (auto x = all.rbegin(); x != all.rend(); ++x) {
      if (fact.value.degree(*x) != 1 || !is_positive(fact.value.coeff(*x, 1))) continue;
      const ex factor = fact.value.coeff(*x, 1);
      const ex bound = (-fact.value.coeff(*x, 0) / factor).expand();
      if (!any_bound && !is_surely(domain_.signs().of(bound), Sign::not_negative)) continue;
      const auto growth = static_cast<double>(term_count(bound) + 1);
      if (static_cast<double>(term_count(value)) * std::pow(growth, value.degree(*x)) > largest_ordered) {
        continue;
      }
      const ex parameter = domain_.indeterminates().fresh(Indeterminates::Kind::parameter, 0);
      domain_.signs().know(parameter, fact.sign);
      const auto put = [&](const ex& into) {
        return into.subs(*x == bound + parameter, GiNaC::subs_options::no_pattern).expand();
      };
      value = put(value);
      facts.erase(facts.begin() + static_cast<std::ptrdiff_t>(i));
      for (Fact& each : facts) each.value = put(each.value);
      return true;
    }
  }
  return false;
}

Sign Order::by_roots(const ex& value, const std::vector<Fact>& facts, int depth) {
  if (depth == largest_depth_of_roots || term_count(value) > largest_root_sum) return Sign::any;
  GiNaC::exvector upper;
  for (const ex& term : terms_of(value)) {
    if (is_surely(domain_.signs().of(term), Sign::not_negative)) upper.push_back(term);
  }
  if (upper.empty()) return Sign::any;
  const ex u = GiNaC::add(upper);
  const ex v = u - value;
  const auto terms =
      static_cast<double>(term_count(u) * term_count(u) + term_count(value) * term_count(value));
  const ex squares = domain_.reduced(u * u - v * v, terms);
  const Sign sign = best(squares, facts, depth + 1);
  if (is_surely(sign, Sign::positive)) return Sign::positive;
  return is_surely(sign, Sign::not_negative) ? Sign::not_negative : Sign::any;
}

Sign Order::best(const ex& value, const std::vector<Fact>& facts, int depth) {
  Sign sign = by_facts(value, facts, 0);
  if (sign == Sign::any) sign = by_squares(value, 0);
  return sign == Sign::any ? by_roots(value, facts, depth) : sign;
}

/// A polynomial in one indeterminate as a product, another one as a product of powers.
ex Order::taken_apart(const ex& value) {
  const GiNaC::exset letters = letters_of(value);
  if (letters.size() != 1 || value.degree(*letters.begin()) > largest_degree_factored)
    return with_repeated_factors(value, domain_.budget());
  domain_.count(price::factored_term * static_cast<double>(term_count(value)));
  return GiNaC::factor(value);
}

/// Of a polynomial that is a product: of indeterminates, of facts, of powers, and of what is left.
Sign Order::by_factors(const ex& value, const std::vector<Fact>& facts) {
  if (!GiNaC::is_a<GiNaC::add>(value) || term_count(value) > largest_factored) return Sign::any;
  Sign sign = Sign::positive;
  ex rest = value;
  const auto take = [&](const ex& factor, Sign own) {
    ex quotient;
    while (!is_number(rest) && divides(factor, rest, quotient, domain_.budget())) {
      rest = quotient;
      sign = product(sign, own);
    }
  };
  for (const ex& x : domain_.indeterminates().all()) {
    if (value.ldegree(x) > 0) take(x, best(x, facts, 0));
  }
  for (const Fact& fact : facts) {
    if (!is_number(fact.value) && term_count(fact.value) <= largest_factored) take(fact.value, fact.sign);
  }
  std::map<std::string, Divisor> in_order;  // that, and their signs, are the same in every run
  for (const ex& factor : factors_of(taken_apart(rest))) {
    const bool raised = GiNaC::is_a<GiNaC::power>(factor);
    const int exponent = raised ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    ex base = (raised ? factor.op(0) : factor).expand();
    const auto [text, negative] = domain_.indeterminates().unsigned_fingerprint(base);
    if (negative) base = (-base).expand();
    if (negative && exponent % 2 != 0) sign = opposite(sign);
    const auto [at, is_new] = in_order.try_emplace(text, Divisor{base, exponent});
    if (!is_new) at->second.exponent += exponent;
  }
  for (const auto& [text, factor] : in_order) {
    Sign own = best(factor.base, facts, 0);
    if (own == Sign::any) own = opposite(best((-factor.base.written()).expand(), facts, 0));
    sign = product(sign, power(own, factor.exponent));
  }
  return sign;
}

bool Order::is_within(const ex& value, Sign allowed, const std::vector<Fact>& facts) {
  for (const auto& [root, square] : domain_.radicals().roots()) {
    if (!value.has(root) || is_surely(domain_.signs().of(root), Sign::positive)) continue;
    if (proves(square, Sign::positive, facts)) domain_.signs().know(root, Sign::positive);
  }
  return proves(value, allowed, facts);
}

bool Order::proves(const ex& value, Sign allowed, const std::vector<Fact>& facts) {
  attempts_ = 0;
  const auto fits = [&](const ex& of, const std::vector<Fact>& with) {
    return is_surely(best(of, with, 0), allowed) ||
           is_surely(opposite(best((-of).expand(), with, 0)), allowed) ||
           is_surely(by_factors(of, with), allowed);
  };
  if (fits(value, facts)) return true;
  for (const bool any_bound : {false, true}) {
    ex rest = value;
    std::vector<Fact> open = facts;
    bool any = false;
    while (parametrize(rest, open, any_bound)) any = true;
    if (any && fits(rest.expand(), open)) return true;
  }
  return false;
}

}  // namespace rigor
