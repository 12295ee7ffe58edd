// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/division.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "algebra/engine/terms.h"
#include "algebra/ring/expansion.h"
#include "algebra/ring/fraction.h"
#include "algebra/ring/line_image.h"

namespace rigor {

using GiNaC::ex;

namespace {

/// Sorted by degree, as GiNaC has them, then by creation, which the numbers in their names count. The result
/// of sqrfree depends on the order, and GiNaC's own differs from run to run.
[[nodiscard]] GiNaC::lst letters_in_order(const ex& expanded) {
  std::map<std::string, std::pair<int, ex>> degrees;  // by name
  for (const ex& term : terms_of(expanded)) {
    for (const ex& factor : factors_of(term)) {
      const auto [base, exponent] = split_power(factor);
      if (!GiNaC::is_a<GiNaC::symbol>(base)) continue;
      auto& known = degrees.try_emplace(GiNaC::ex_to<GiNaC::symbol>(base).get_name(), 0, base).first->second;
      known.first = std::max(known.first, exponent);
    }
  }
  std::map<std::tuple<int, std::size_t, std::string>, ex> in_order;
  for (const auto& [name, letter] : degrees)
    in_order.emplace(std::tuple(letter.first, name.size(), name), letter.second);
  GiNaC::lst letters;
  for (const auto& [place, letter] : in_order) letters.append(letter);
  return letters;
}

/// Lines and divisions go over all terms again for each few powers of a letter.
[[nodiscard]] std::size_t weight_of_degree(const ex& expanded) {
  constexpr int per_weight = 8;
  int highest = 0;
  for (const ex& term : terms_of(expanded)) {
    for (const ex& factor : factors_of(term)) highest = std::max(highest, split_power(factor).second);
  }
  return static_cast<std::size_t>(1 + highest / per_weight);
}

/// Letters with their exponents; nothing where it is no product of such.
[[nodiscard]] std::optional<std::vector<std::pair<ex, int>>> letters_of_monomial(const ex& value) {
  if (GiNaC::is_a<GiNaC::add>(value)) return std::nullopt;
  std::vector<std::pair<ex, int>> letters;
  for (const ex& factor : factors_of(value)) {
    if (is_number(factor)) continue;
    letters.push_back(split_power(factor));
    if (!GiNaC::is_a<GiNaC::symbol>(letters.back().first) || letters.back().second < 0) return std::nullopt;
  }
  return letters;
}

/// Term by term: a monomial divides what is expanded if it divides each term.
[[nodiscard]] bool divides_each_term(const ex& monomial, const std::vector<std::pair<ex, int>>& letters,
                                     const ex& value, ex& quotient) {
  const ex inverse = 1 / monomial;
  GiNaC::exvector terms;
  for (const ex& term : terms_of(value)) {
    std::size_t found = 0;
    for (const ex& factor : factors_of(term)) {
      const auto [base, exponent] = split_power(factor);
      found += std::ranges::any_of(letters, [&, &base = base, exponent = exponent](const auto& letter) {
        return exponent >= letter.second && base.is_equal(letter.first);
      });
    }
    if (found < letters.size()) return false;
    terms.push_back(term * inverse);
  }
  quotient = GiNaC::add(terms);
  return true;
}

}  // namespace

std::size_t size_of_division(const ex& divisor, const ex& value) {
  return term_count(divisor) * term_count(value) * weight_of_degree(value);
}

bool divides(const ex& divisor, const ex& value, ex& quotient, Budget* budget) {
  const std::size_t terms = term_count(value) + term_count(divisor);
  if (const auto letters = value.is_zero() ? std::nullopt : letters_of_monomial(divisor)) {
    if (budget != nullptr) budget->count((price::looked_at_term + price::expanded_term) * terms);
    return divides_each_term(divisor, *letters, value, quotient);
  }
  if (budget != nullptr) budget->count(price::looked_at_term * terms * weight_of_degree(value));
  if (!may_divide(divisor, value)) return false;
  if (budget != nullptr) budget->count(price::divided_pair * size_of_division(divisor, value));
  if (!GiNaC::divide(value, divisor, quotient)) return false;
  quotient = expanded_polynomial(quotient);  // GiNaC leaves it by powers of some variable
  return true;
}

bool may_be_factored(const ex& expanded) {
  constexpr std::size_t most_terms = 32;
  constexpr double most_monomials = 4'000;
  if (term_count(expanded) > most_terms) return false;
  std::map<ex, int, GiNaC::ex_is_less> degrees;
  for (const ex& term : terms_of(expanded)) {
    for (const ex& factor : factors_of(term)) {
      const auto [base, exponent] = split_power(factor);
      if (!is_number(base)) degrees[base] = std::max(degrees[base], std::abs(exponent));
    }
  }
  double monomials = 1;
  for (const auto& [variable, degree] : degrees) monomials *= degree + 1;
  return monomials <= most_monomials;
}

ex with_repeated_factors(const ex& value, Budget* budget) {
  const std::size_t terms = term_count(value);
  if (budget != nullptr) budget->count(price::looked_at_term * terms);
  if (!may_repeat_a_factor(value)) return value;
  if (budget != nullptr) budget->count(price::factored_term * terms);
  return GiNaC::sqrfree(value, letters_in_order(value));
}

}  // namespace rigor
