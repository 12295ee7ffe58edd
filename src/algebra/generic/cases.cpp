// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/cases.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>

#include "algebra/engine/terms.h"
#include "algebra/ring/division.h"
#include "algebra/ring/membership.h"

namespace rigor {
namespace {

constexpr int largest_cases = 24;
constexpr int largest_substitutions = 200;
constexpr double largest_substituted = 5000;   // terms, by the estimate
constexpr std::size_t largest_divided = 2000;  // terms times terms

/// A product of powers is zero exactly if one of the bases is: each once.
[[nodiscard]] Numerator without_powers(const Numerator& equation, const PackedLetters& letters) {
  const PackedPolynomial* const packed = equation.packed(letters);
  if (packed == nullptr || packed->is_number() || packed->size() > 1) return equation;
  std::vector<std::pair<std::size_t, int>> once;
  packed->for_each_power(0, [&](std::size_t letter, int) { once.emplace_back(letter, 1); });
  return {PackedPolynomial(1, once), letters};
}

[[nodiscard]] bool is_constant(const Numerator& value, const PackedLetters& letters) {
  const PackedPolynomial* const packed = value.packed(letters);
  return packed == nullptr ? is_number(value.written()) : packed->is_number();
}

[[nodiscard]] std::size_t terms_in(const Numerator& value, const PackedLetters& letters) {
  const PackedPolynomial* const packed = value.packed(letters);
  return packed == nullptr ? term_count(value.written()) : packed->size();
}

}  // namespace

Numerator without_factors(Numerator value, const std::vector<Numerator>& factors,
                          const PackedLetters& letters, Budget* budget) {
  Numerator quotient;
  for (const Numerator& factor : factors) {
    if (is_constant(factor, letters)) continue;
    while (!is_constant(value, letters) &&
           terms_in(value, letters) * terms_in(factor, letters) <= largest_divided &&
           divides(factor, value, quotient, letters, budget)) {
      value = quotient;
    }
  }
  return value;
}

Numerator Cases::without_nonzero(const Numerator& value, const System& system) const {
  return without_factors(value, system.nonzero, letters(), domain_.budget());
}

/// Drops what is satisfied, and factors that are not 0; false if an equation cannot hold.
bool Cases::tidy(System& system) {
  std::vector<Numerator> open;
  for (const Numerator& each : system.nonzero) {
    if (each.is_zero()) return false;
  }
  for (const Numerator& each : system.equations) {
    if (each.is_zero()) continue;
    const Numerator rest = without_powers(without_nonzero(each, system), letters());
    if (is_constant(rest, letters())) return false;
    open.push_back(rest);
  }
  system.equations = std::move(open);
  return true;
}

/// The one whose factor has the fewest terms; among equals the first, in an order that is the same in every
/// run.
std::optional<Cases::Linear> Cases::simplest_linear(const System& system, bool known_factor) const {
  std::optional<Linear> best;
  std::size_t fewest = 0;
  for (std::size_t i = 0; i < system.equations.size(); ++i) {
    const PackedPolynomial* const equation = system.equations[i].packed(letters());
    if (equation == nullptr) continue;
    const std::vector<int> degrees = equation->degrees(letters().count());
    for (std::size_t x = 0; x < degrees.size(); ++x) {
      if (degrees[x] != 1 || domain_.radicals().is_radical(letters().at(x))) continue;
      const Numerator factor(equation->coefficient_of(x, 1), letters());
      const std::size_t terms = terms_in(factor, letters());
      if (best && terms >= fewest) continue;
      if (known_factor && !is_constant(without_nonzero(factor, system), letters())) continue;
      best = Linear{x, factor, Numerator(equation->coefficient_of(x, 0), letters()), i};
      fewest = terms;
    }
  }
  return best;
}

/// a^d p(−b/a) for a polynomial p(x) of degree d.
Numerator Cases::substituted(const Numerator& value, const Linear& by) {
  const PackedPolynomial* const polynomial = value.packed(letters());
  if (polynomial == nullptr) throw Undecidable("the degree of an assumption is too high");
  const int degree = polynomial->degree_in(by.x);
  if (degree == 0) return value;
  const Numerator opposite = by.constant.negated(letters());
  const auto growth =
      static_cast<double>(std::max(terms_in(by.constant, letters()), terms_in(by.factor, letters())));
  Numerator sum;
  double terms = 0;
  for (int k = 0; k <= degree; ++k) {
    PackedPolynomial coefficient = polynomial->coefficient_of(by.x, k);
    if (coefficient.is_zero()) continue;
    terms += static_cast<double>(coefficient.size()) * std::pow(growth, degree);
    Numerator part(std::move(coefficient), letters());
    if (k > 0) part = part.times(opposite.to_power(k, letters()), letters());
    if (k < degree) part = part.times(by.factor.to_power(degree - k, letters()), letters());
    sum.add(part, letters());
  }
  if (terms > largest_substituted) throw Undecidable("solving the assumptions takes too many terms");
  return domain_.reduced(sum, terms);
}

/// False if the case turns out to be impossible.
bool Cases::substitute(Numerator& value, System& system, const Linear& by) {
  if (++substitutions_ > largest_substitutions) throw Undecidable("solving the assumptions takes too long");
  system.equations.erase(system.equations.begin() + static_cast<std::ptrdiff_t>(by.equation));
  for (Numerator& each : system.equations) each = substituted(each, by);
  for (Numerator& each : system.nonzero) each = substituted(each, by);
  std::erase_if(system.nonzero,
                [&](const Numerator& each) { return is_constant(each, letters()) && !each.is_zero(); });
  value = without_nonzero(substituted(value, by), system);
  return tidy(system);
}

/// Solves what is linear with a factor that is known to be nonzero; false if the case is impossible.
bool Cases::simplify(Numerator& value, System& system) {
  if (!tidy(system)) return false;
  while (const auto linear = simplest_linear(system, true)) {
    if (!substitute(value, system, *linear)) return false;
  }
  return true;
}

Cases::Verdict Cases::split(const Numerator& value, const System& system, const Linear& by) {
  if ((opened_ += 2) > largest_cases) {
    throw Undecidable("its assumptions split into too many cases");
  }
  System with_factor = system;
  with_factor.nonzero.push_back(by.factor);
  const Verdict first = decide(value, std::move(with_factor));
  if (first == Verdict::open) return first;
  System without_factor = system;
  without_factor.equations[by.equation] = by.factor;
  without_factor.equations.push_back(by.constant);
  const Verdict second = decide(value, std::move(without_factor));
  return second == Verdict::empty ? first : second;
}

Cases::Verdict Cases::decide(const Numerator& value, System system) {
  Numerator rest = value;
  if (!simplify(rest, system)) return Verdict::empty;
  if (rest.is_zero()) return Verdict::vanishes;
  if (system.equations.empty()) return Verdict::open;
  if (is_combination(rest, system.equations, letters(), {.budget = domain_.budget()}))
    return Verdict::vanishes;
  const auto linear = simplest_linear(system, false);
  return linear ? split(rest, system, *linear) : Verdict::open;
}

}  // namespace rigor
