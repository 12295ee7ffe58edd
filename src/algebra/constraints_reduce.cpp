// SPDX-License-Identifier: GPL-3.0-or-later
// What the solved assumptions make of a polynomial: the part of Constraints that a claim meets.
#include <ginac/ginac.h>

#include <algorithm>

#include "algebra/constraints.h"
#include "algebra/membership.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_division = 100'000;  // terms times terms
constexpr std::size_t largest_product = 500;       // terms
constexpr std::size_t largest_tried = 8;           // factors that are not 0

[[nodiscard]] bool is_number(const ex& value) { return GiNaC::is_a<GiNaC::numeric>(value); }

/// Is a division worth its time?
[[nodiscard]] bool is_divided(const ex& dividend, const ex& divisor) {
  return term_count(dividend) * term_count(divisor) <= largest_division;
}

}  // namespace

/// By the equations that could be solved for an indeterminate.
ex Constraints::solved(const ex& value) {
  ex rest = value;
  for (const Solution& solution : solutions_) {
    if (rest.is_zero()) return rest;
    substitute(rest, used_, solution);
  }
  return rest;
}

ex Constraints::reduced(const ex& value) {
  ex rest = solved(value);
  for (const Remaining& each : remaining_) {
    if (rest.is_zero()) return rest;
    if (!each.monic_in.is_zero() && is_divided(rest, each.equation) &&
        rest.degree(each.monic_in) >= each.equation.degree(each.monic_in)) {
      rest = GiNaC::rem(rest, each.equation, each.monic_in).expand();
      used_.insert(each.from.begin(), each.from.end());
    }
  }
  return rest;
}

void Constraints::note_nonzero(const ex& value) {
  const bool known =
      std::any_of(nonzero_.begin(), nonzero_.end(), [&](const ex& each) { return each.is_equal(value); });
  if (!known && !is_number(value)) nonzero_.push_back(value);
}

/// Is the value, or its product with something that is not 0, a combination of the equations?
bool Constraints::is_combination_times_nonzero(const ex& value, const System& system) {
  const std::vector<ex>& all = domain_.indeterminates().all();
  if (is_combination(value, system.equations, all)) return true;
  std::size_t tried = 0;
  return std::any_of(system.nonzero.begin(), system.nonzero.end(), [&](const ex& factor) {
    if (is_number(factor) || term_count(factor) * term_count(value) > largest_product) return false;
    if (++tried > largest_tried) return false;
    return is_combination((value * factor).expand(), system.equations, all);
  });
}

std::set<std::size_t> Constraints::used(bool signs) const {
  std::set<std::size_t> all = used_;
  if (signs) all.insert(orders_.begin(), orders_.end());
  return all;
}

void Constraints::use_all_remaining() {
  for (const Remaining& each : remaining_) used_.insert(each.from.begin(), each.from.end());
  used_.insert(orders_.begin(), orders_.end());
}

/// Is the value a multiple of a determinant that is zero?
bool Constraints::is_determinant(const ex& value) {
  return std::any_of(determinants_.begin(), determinants_.end(), [&](const Known& each) {
    const ex determinant = solved(each.equation);
    if (determinant.is_zero() ||
        !is_combination(value, std::span(&determinant, 1), domain_.indeterminates().all()))
      return false;
    used_.insert(each.from.begin(), each.from.end());
    return true;
  });
}

bool Constraints::vanishes(const ex& value) {
  const ex open = solved(value);
  if (open.is_zero()) return true;
  if (remaining_.empty()) return false;
  if (is_determinant(open)) return true;
  use_all_remaining();
  System system;
  for (const Remaining& each : remaining_) system.equations.push_back(each.equation);
  for (const ex& each : nonzero_) system.nonzero.push_back(reduced(each));
  const ex without = without_factors(open, system.nonzero);
  if (is_combination_times_nonzero(without, system)) return true;
  const ex rest = reduced(open);
  if (rest.is_zero()) return true;
  const Cases::Verdict verdict = Cases(domain_).decide(without_factors(rest, system.nonzero), system);
  if (verdict == Cases::Verdict::empty) throw Undecidable("the assumptions contradict each other");
  return verdict == Cases::Verdict::vanishes;
}

}  // namespace rigor
