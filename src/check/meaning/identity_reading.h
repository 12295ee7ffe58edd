// SPDX-License-Identifier: GPL-3.0-or-later
// Is an equation that does not hold for all values a wrong identity, or a law? `m\mathbf a = q\mathbf
// v\times\mathbf B` relates quantities; nobody claims it for all m, a, q, v, B, and refuting it would be a
// false alarm. `|\mathbf A\times\mathbf B|^2 = A^2B^2 + (\mathbf A\cdot\mathbf B)^2` is claimed for all A and
// B.
//
// What a letter is makes no claim: only `for all` says that a statement is meant for all values of a symbol.
// For the others the form decides. An equation reads as an identity if
//  - both sides have the same symbols (one symbol alone, to the first power on both sides, is a condition:
//  T_ij = T_ji),
//  - or one side has symbols of its own, all in one term of a sum, and the equation becomes a true identity,
//  not 0 = 0, when they are 0: a term too many (`(x - a)^2 + y^2 = a^2` is a circle, `H + \partial_tF = H`
//  says that one vanishes: a condition),
//  - or one side is 0 and the other a sum whose terms have the same degree in every symbol: a wrong Jacobi
//  identity.
#pragma once

#include <set>
#include <vector>

#include "elaborate/name/scope.h"
#include "expr/statement/statement.h"

namespace rigor {

class DecisionCache;

/// The symbols, not meant for all values, for which the equation reads as a law or condition; none if it
/// reads as an identity. `restates`: the left side is a defined symbol alone, so one common symbol makes no
/// condition of it. The rotations that carry turning axes turn by an angular velocity: if nothing else is
/// defined, it is on a side only if it is written there.
[[nodiscard]] std::vector<SymbolId> law_symbols(const Question& question, const NameScope& scope,
                                                bool restates = false, DecisionCache* cache = nullptr);

/// A term of a side: a sum within a sum belongs to the outer one.
struct SignedTerm {
  bool negative = false;
  ExprId id;
};
[[nodiscard]] std::vector<SignedTerm> signed_terms(const ExprTree& tree, ExprId side);

/// 2 of `\cos\theta \approx 1 - \theta^2/2`: the highest whole power of what is small that is a factor of a
/// term on the right side; 1 where there is none. What only the left side has is left out.
[[nodiscard]] int order_shown(const ExprTree& tree, const NameScope& scope, const Equation& equation);

/// The symbols below both sides, with the definitions in the question unfolded: what the equation is about in
/// the end.
[[nodiscard]] std::vector<SymbolId> primitive_symbols(const Question& question, ExprId root);

/// Do both sides of the claim lead to the same symbols in the end?
[[nodiscard]] bool relates_the_same_letters(const Question& question);

}  // namespace rigor
