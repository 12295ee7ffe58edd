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

using GiNaC::ex;

constexpr int largest_cases = 24;
constexpr int largest_substitutions = 200;
constexpr double largest_substituted = 5000;   // terms, by the estimate
constexpr std::size_t largest_divided = 2000;  // terms times terms

/// base^exponent, with 0^0 = 1 as in a polynomial; GiNaC refuses that.
[[nodiscard]] ex natural_power(const ex& base, int exponent) {
  return exponent == 0 ? ex{1} : GiNaC::pow(base, exponent);
}

/// A product of powers is zero exactly if one of the bases is: each once.
[[nodiscard]] ex without_powers(const ex& equation) {
  if (GiNaC::is_a<GiNaC::power>(equation)) return equation.op(0);
  if (!GiNaC::is_a<GiNaC::mul>(equation)) return equation;
  ex product = 1;
  for (std::size_t i = 0; i < equation.nops(); ++i) {
    const ex factor = equation.op(i);
    if (!is_number(factor)) product *= GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
  }
  return product;
}

}  // namespace

ex without_factors(ex value, const std::vector<ex>& factors, Budget* budget) {
  ex quotient;
  for (const ex& factor : factors) {
    if (is_number(factor)) continue;
    while (!is_number(value) && term_count(value) * term_count(factor) <= largest_divided &&
           divides(factor, value, quotient, budget)) {
      value = quotient;
    }
  }
  return value;
}

/// Drops what is satisfied, and factors that are not 0; false if an equation cannot hold.
bool Cases::tidy(System& system) {
  std::vector<ex> open;
  for (const ex& each : system.nonzero) {
    if (each.is_zero()) return false;
  }
  for (const ex& each : system.equations) {
    if (each.is_zero()) continue;
    const ex rest = without_powers(without_factors(each, system.nonzero, domain_.budget()));
    if (is_number(rest)) return false;
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
    const ex& equation = system.equations[i];
    const Degrees degrees = degrees_of(equation);
    for (const ex& x : domain_.indeterminates().all()) {
      if (degree_in(degrees, x) != 1 || domain_.radicals().is_radical(x)) continue;
      const ex factor = equation.coeff(x, 1);
      const std::size_t terms = term_count(factor);
      if (best && terms >= fewest) continue;
      if (known_factor && !is_number(without_factors(factor, system.nonzero, domain_.budget()))) continue;
      best = Linear{x, factor, equation.coeff(x, 0), i};
      fewest = terms;
    }
  }
  return best;
}

/// a^d p(−b/a) for a polynomial p(x) of degree d.
ex Cases::substituted(const ex& value, const Linear& by) {
  const int degree = value.degree(by.x);
  if (degree == 0) return value;
  GiNaC::exvector summands;
  double terms = 0;
  for (int k = 0; k <= degree; ++k) {
    const ex coefficient = value.coeff(by.x, k);
    if (coefficient.is_zero()) continue;
    summands.push_back(coefficient * natural_power(-by.constant, k) * natural_power(by.factor, degree - k));
    const auto growth = static_cast<double>(std::max(term_count(by.constant), term_count(by.factor)));
    terms += static_cast<double>(term_count(coefficient)) * std::pow(growth, degree);
  }
  if (terms > largest_substituted) throw Undecidable("solving the assumptions takes too many terms");
  return domain_.reduced(GiNaC::add(summands), terms);
}

/// False if the case turns out to be impossible.
bool Cases::substitute(ex& value, System& system, const Linear& by) {
  if (++substitutions_ > largest_substitutions) throw Undecidable("solving the assumptions takes too long");
  system.equations.erase(system.equations.begin() + static_cast<std::ptrdiff_t>(by.equation));
  for (ex& each : system.equations) each = substituted(each, by);
  for (ex& each : system.nonzero) each = substituted(each, by);
  std::erase_if(system.nonzero, [](const ex& each) { return is_number(each) && !each.is_zero(); });
  value = without_factors(substituted(value, by), system.nonzero, domain_.budget());
  return tidy(system);
}

/// Solves what is linear with a factor that is known to be nonzero; false if the case is impossible.
bool Cases::simplify(ex& value, System& system) {
  if (!tidy(system)) return false;
  while (const auto linear = simplest_linear(system, true)) {
    if (!substitute(value, system, *linear)) return false;
  }
  return true;
}

Cases::Verdict Cases::split(const ex& value, const System& system, const Linear& by) {
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

Cases::Verdict Cases::decide(const ex& value, System system) {
  ex rest = value;
  if (!simplify(rest, system)) return Verdict::empty;
  if (rest.is_zero()) return Verdict::vanishes;
  if (system.equations.empty()) return Verdict::open;
  if (is_combination(rest, system.equations, domain_.indeterminates().all(), {.budget = domain_.budget()}))
    return Verdict::vanishes;
  const auto linear = simplest_linear(system, false);
  return linear ? split(rest, system, *linear) : Verdict::open;
}

}  // namespace rigor
