// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of derivations share: polynomials of terms, and whether the exact side finds two terms
// equal.
#pragma once

#include "algebra/decide/decide.h"
#include "catch.h"
#include "derive/polynomial/index_polynomial.h"
#include "expr/build.h"

namespace rigor::build {

[[nodiscard]] inline IndexPolynomial polynomial(const Term& term) {
  auto result = polynomial_of(*term.tree, term.id);
  REQUIRE(result);
  return *std::move(result);
}

[[nodiscard]] inline Term written(Page& page, const IndexPolynomial& polynomial) {
  return {&page.tree, expression_of(page.tree, polynomial)};
}

[[nodiscard]] inline Outcome outcome(Page& page, const Term& left, const Term& right,
                                     std::vector<IndexId> free = {}) {
  return decide(page.claim(left, right, std::move(free))).outcome;
}

}  // namespace rigor::build
