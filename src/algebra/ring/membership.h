// SPDX-License-Identifier: GPL-3.0-or-later
// Is a polynomial a combination Σ g_k f_k of equations f_k = 0? Method: the cofactors' monomials are guessed
// (those by which a term of an equation becomes a monomial that is present already, again and again, within a
// bound), and the combination is found by exact linear algebra: a row for each multiple of an equation, a
// column for each monomial (F. S. Macaulay, "The algebraic theory of modular systems", 1916). Sound: what
// reduces to zero is such a combination. Incomplete by the bounds.
#pragma once

#include <ginac/ex.h>

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "algebra/engine/budget.h"
#include "algebra/packed/numerator.h"
#include "algebra/ring/sparse_polynomial.h"

namespace rigor {

struct MembershipLimits {
  std::size_t multiples = 60;  // of equations
  std::size_t operations = 100'000;
  Budget* budget = nullptr;  // counts the operations, if there is one
};

/// The positions of the equations that take part in a combination; empty if none was found.
[[nodiscard]] std::optional<std::set<std::size_t>> combination(const Numerator& value,
                                                               std::span<const Numerator> equations,
                                                               const PackedLetters& letters,
                                                               const MembershipLimits& limits = {});

[[nodiscard]] bool is_combination(const Numerator& value, std::span<const Numerator> equations,
                                  const PackedLetters& letters, const MembershipLimits& limits = {});

/// The cofactors g_k of a combination Σ g_k f_k that is the value, one for each equation; empty if none was
/// found. The same search once more with an account of what was subtracted, which takes about twice as long.
[[nodiscard]] std::optional<std::vector<SparsePolynomial>> cofactors(
    const SparsePolynomial& value, std::span<const SparsePolynomial> equations,
    const MembershipLimits& limits = {});

}  // namespace rigor
