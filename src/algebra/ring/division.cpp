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
[[nodiscard]] std::size_t weight_of_degree(int highest_exponent) {
  constexpr int per_weight = 8;
  return static_cast<std::size_t>(1 + highest_exponent / per_weight);
}

[[nodiscard]] int highest_exponent(const ex& expanded) {
  int highest = 0;
  for (const auto& [base, exponent] : degrees_of(expanded)) highest = std::max(highest, exponent);
  return highest;
}

[[nodiscard]] int highest_exponent(const PackedPolynomial& value) {
  int highest = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
    value.for_each_power(i, [&](std::size_t, int exponent) { highest = std::max(highest, exponent); });
  return highest;
}

void count_on(Budget* budget, std::uint64_t units) {
  if (budget != nullptr) budget->count(units);
}

}  // namespace

std::size_t size_of_division(const ex& divisor, const ex& value) {
  return term_count(divisor) * term_count(value) * weight_of_degree(highest_exponent(value));
}

bool divides(const Numerator& divisor, const Numerator& value, Numerator& quotient,
             const PackedLetters& letters, Budget* budget) {
  const PackedPolynomial* const below = divisor.packed(letters);
  const PackedPolynomial* const above = value.packed(letters);
  if (below == nullptr || above == nullptr || below->is_zero()) {
    ex found;
    if (!GiNaC::divide(value.written(), divisor.written(), found)) return false;
    quotient = found.expand();
    return true;
  }
  const std::size_t terms = below->size() + above->size();
  if (below->size() == 1 && !above->is_zero()) {
    count_on(budget, (price::looked_at_term + price::expanded_term) * terms);
  } else {
    const std::size_t weight = weight_of_degree(highest_exponent(*above));
    count_on(budget, price::looked_at_term * terms * weight);
    if (!may_divide(*below, *above, letters)) return false;
    count_on(budget, price::divided_pair * below->size() * above->size() * weight);
  }
  auto found = exact_quotient(*above, *below);
  if (found) quotient = Numerator(std::move(*found), letters);
  return found.has_value();
}

bool divides(const ex& divisor, const ex& value, ex& quotient, Budget* budget) {
  PackedLetters letters;
  add_letters(letters, value);
  add_letters(letters, divisor);
  Numerator found;
  if (!divides(divisor, value, found, letters, budget)) return false;
  quotient = found.written();
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
