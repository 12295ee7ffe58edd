// SPDX-License-Identifier: GPL-3.0-or-later
// What the solved assumptions make of a polynomial: the part of Constraints that a claim meets.
#include <ginac/ginac.h>

#include <algorithm>
#include <utility>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/generic/constraints.h"
#include "algebra/ring/membership.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_division = 100'000;  // terms times terms
constexpr std::size_t largest_product = 500;       // terms
constexpr std::size_t largest_tried = 12;          // factors that are not 0, and their squares
constexpr int largest_reduced_power = 2;           // of one of them

/// Is a division worth its time?
[[nodiscard]] bool is_divided(const ex& dividend, const ex& divisor) {
  return term_count(dividend) * term_count(divisor) <= largest_division;
}

}  // namespace

/// By the equations that could be solved for an indeterminate.
Numerator Constraints::solved(const Numerator& value) {
  Numerator rest = value;
  for (const Solution& solution : solutions_) {
    if (rest.is_zero()) return rest;
    substitute(rest, used_, solution);
  }
  return rest;
}

Numerator Constraints::reduced(const Numerator& value) {
  Numerator rest = solved(value);
  for (const Remaining& each : remaining_) {
    if (rest.is_zero()) return rest;
    if (!each.monic_in.is_zero() && is_divided(rest, each.equation) &&
        rest.written().degree(each.monic_in) >= each.equation.written().degree(each.monic_in)) {
      domain_.count(static_cast<double>(term_count(rest) * term_count(each.equation)));
      rest = GiNaC::rem(rest.written(), each.equation, each.monic_in).expand();
      use(each.from);
    }
  }
  return rest;
}

/// Where a root is not 0, its square is not: that is what stands in `r^2E = r^3\rho` of a length r.
void Constraints::note_nonzero(const Numerator& value, std::optional<std::size_t> assumption) {
  const auto note = [&](const Numerator& each) {
    const auto is_it = [&](const auto& known) { return known.value.is_equal(each, letters()); };
    const PackedPolynomial* const packed = each.packed(letters());
    if ((packed == nullptr ? is_number(each.written()) : packed->is_number()) ||
        std::ranges::any_of(trace_.nonzero, is_it))
      return;
    trace_.nonzero.push_back({each, assumption});
  };
  note(value);
  for (const auto& [root, square] : domain_.radicals().relations()) {
    if (root.is_equal(value.written()) || root.is_equal(-value.written())) note(square);
  }
}

/// Is the value, or its product with something that is not 0, a combination of the equations?
bool Constraints::is_combination_times_nonzero(const Numerator& value, const System& system,
                                               ConstraintsTrace::Vanishing& found) {
  const auto is_zero = [&](const Numerator& product) {
    const auto taken = combination(product, system.equations, letters(), {.budget = domain_.budget()});
    if (!taken) return false;
    for (const std::size_t each : *taken) use(remaining_[found.left[each]].from);
    return true;
  };
  found.how = ConstraintsTrace::Vanishing::How::combination;
  found.core = value;
  if (is_zero(value)) return true;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < system.nonzero.size(); ++i) {
    const Numerator& factor = system.nonzero[i];
    const PackedPolynomial* const packed = factor.packed(letters());
    if (packed == nullptr || packed->is_number()) continue;
    Numerator product = value;
    Numerator alone = 1;
    for (int power = 1; power <= largest_reduced_power; ++power) {
      if (packed->size() * domain_.term_count(product) > largest_product || ++tried > largest_tried) break;
      product = product.times(factor, letters()).expanded(letters());
      alone = alone.times(factor, letters()).expanded(letters());
      if (!is_zero(product)) continue;
      if (is_combination(alone, system.equations, letters(), {.budget = domain_.budget()}))
        throw Contradiction();
      found.nonzero = i;
      found.power = power;
      return true;
    }
  }
  return false;
}

/// The positions of the remaining equations that share indeterminates with a value, directly or through
/// others.
std::vector<std::size_t> Constraints::remaining_about(const Numerator& value) const {
  std::set<std::size_t> met = domain_.indeterminates().positions_in(value);
  std::vector<bool> taken(remaining_.size(), false);
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
      const std::set<std::size_t>& own = remaining_[i].indeterminates;
      if (taken[i] || std::ranges::none_of(own, [&](std::size_t x) { return met.contains(x); })) continue;
      taken[i] = grew = true;
      met.insert(own.begin(), own.end());
    }
  }
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) which.push_back(i);
  }
  return which;
}

std::set<std::size_t> Constraints::used(bool signs) const {
  std::set<std::size_t> all = used_;
  if (signs) all.insert(orders_.begin(), orders_.end());
  return all;
}

void Constraints::use(const Positions& positions) { used_.insert(positions.begin(), positions.end()); }

/// Is the value a multiple of a determinant that is zero?
bool Constraints::is_determinant(const Numerator& value, ConstraintsTrace::Vanishing& found) {
  found.how = ConstraintsTrace::Vanishing::How::determinant;
  for (found.determinant = 0; found.determinant < determinants_.size(); ++found.determinant) {
    const Known& each = determinants_[found.determinant];
    const Numerator determinant = solved(each.equation);
    if (determinant.is_zero() ||
        !is_combination(value, std::span(&determinant, 1), letters(), {.budget = domain_.budget()}))
      continue;
    use(each.from);
    return true;
  }
  return false;
}

bool Constraints::vanishes(const Numerator& value) {
  if (value.is_zero()) return true;
  ConstraintsTrace::Vanishing found{.value = value};
  const Positions before = std::exchange(used_, {});
  const bool vanishing = vanishes(value, found);
  found.from = used_;
  use(before);
  if (vanishing) trace_.vanishings.push_back(std::move(found));
  return vanishing;
}

bool Constraints::vanishes(const Numerator& value, ConstraintsTrace::Vanishing& found) {
  const Numerator open = solved(value);
  if (open.is_zero()) return true;
  if (remaining_.empty()) return false;
  if (is_determinant(open, found)) return true;
  found.left = remaining_about(open);
  if (found.left.empty()) return false;
  System system;
  for (const std::size_t each : found.left) system.equations.push_back(remaining_[each].equation);
  for (const ex& each : domain_.functions().never_zero()) note_nonzero(each, std::nullopt);
  const Positions before = used_;  // what is not 0 may need assumptions, but seldom others
  for (const auto& each : trace_.nonzero) system.nonzero.push_back(reduced(each.value));
  used_ = before;
  use(orders_);
  if (is_combination_times_nonzero(without_factors(open, system.nonzero, letters(), domain_.budget()), system,
                                   found))
    return true;
  const Numerator rest = reduced(open);
  found.how = ConstraintsTrace::Vanishing::How::divided;
  if (rest.is_zero()) return true;
  found.how = ConstraintsTrace::Vanishing::How::cases;
  const Cases::Verdict verdict =
      Cases(domain_).decide(without_factors(rest, system.nonzero, letters(), domain_.budget()), system);
  if (verdict == Cases::Verdict::empty) throw Contradiction();
  for (const std::size_t each : found.left) use(remaining_[each].from);
  return verdict == Cases::Verdict::vanishes;
}

}  // namespace rigor
