// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of a polynomial at the generic point, from the signs and facts that are known: for claims with <,
// ≤ and ≠. Method, in this order:
//  1. the signs of its terms;
//  2. a fact that bounds an indeterminate, x = bound + p with a parameter p of the fact's sign, is solved for
//  it: 0 < I_1 < I_2 < I_3 becomes (a, a + b, a + b + c);
//  3. the polynomial is a positive multiple of facts and a rest whose sign is known;
//  4. as a quadratic p x² + 2 q x + r in an indeterminate: it is never negative if p and p r − q² are not
//  (Lagrange's reduction: p P = (p x + q)² + p r − q²) and, where p may be 0, which makes q = 0, r is not;
//  5. the sign of a product of factors is that of its factors: x − x² = x(1 − x);
//  6. U − V is not negative if U and U² − V² are not, where U has the terms that are not negative: A·B ≤
//  |A||B|. For U² ≥ V² makes |U| ≥ |V|, and U = |U|, |V| ≥ V. From U² > V² follows U > V in the same way, but
//  from U² = V² only U = |V|: U − V may be anything that is not negative, 2U where V = −U.
// A root is positive if what is under it is.
// Why each is sound: a sign is the set of signs that a value may have, at every point that meets the
// assumptions and at which the claim has a value. 1 to 3 and 5 add and multiply such sets (`signs.h`), by
// positive numbers, by an exact substitution or by exact division; 4 and 6 give a set
// that holds whatever the other signs are. An empty set says that there is no such point, and proves nothing.
// Incomplete.
#pragma once

#include "algebra/generic/generic_evaluator.h"

namespace rigor {

class Order {
 public:
  explicit Order(GenericDomain& domain) : domain_(domain) {}

  /// Is the polynomial's sign certainly among these? Facts are taken reduced by the caller.
  [[nodiscard]] bool is_within(const GiNaC::ex& value, Sign allowed, const std::vector<Signs::Fact>& facts);

 private:
  [[nodiscard]] bool proves(const GiNaC::ex& value, Sign allowed, const std::vector<Signs::Fact>& facts);
  [[nodiscard]] bool parametrize(GiNaC::ex& value, std::vector<Signs::Fact>& facts, bool any_bound);
  [[nodiscard]] Sign by_facts(const GiNaC::ex& value, const std::vector<Signs::Fact>& facts, int depth);
  [[nodiscard]] Sign by_positive_facts(const GiNaC::ex& value, const std::vector<Signs::Fact>& facts);
  [[nodiscard]] Sign by_squares(const GiNaC::ex& value, int depth);
  [[nodiscard]] Sign by_roots(const GiNaC::ex& value, const std::vector<Signs::Fact>& facts, int depth);
  [[nodiscard]] GiNaC::ex taken_apart(const GiNaC::ex& value);
  [[nodiscard]] Sign by_factors(const GiNaC::ex& value, const std::vector<Signs::Fact>& facts);
  [[nodiscard]] Sign best(const GiNaC::ex& value, const std::vector<Signs::Fact>& facts, int depth);

  GenericDomain& domain_;
  int attempts_ = 0;
};

}  // namespace rigor
