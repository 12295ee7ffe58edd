// SPDX-License-Identifier: GPL-3.0-or-later
// Does a row follow from one set of laws?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/law/page_law.h"
#include "check/verdict/judge.h"

namespace rigor {

/// The row under which laws: what it may rest on, and where the exact side is asked.
struct RowUnderLaws {
  ExprTree& tree;
  const Names& names;
  const Claim& claim;
  DecisionCache* cache;
};

/// The laws taken for granted, under their names.
[[nodiscard]] Names with_laws(const ExprTree& tree, Names names, const Laws& laws);

/// The same, and what nothing on the page differentiates is taken as constant.
[[nodiscard]] Names with_laws_and_constants(const RowUnderLaws& row, const Laws& laws);

/// The same beside no laws, where a solution was put in, a function of `by`: its terms may be constant, as
/// x_0 of `x_0 + vt` is.
[[nodiscard]] Names with_constants_of_solution(const RowUnderLaws& row, Variable by);

/// "`m` is constant, since nothing differentiates it", as `uses` says it.
[[nodiscard]] std::string convention_of_constant(const ExprTree& tree, SymbolId letter);

/// Does a proof with these `uses` take as constant what the row itself differentiates?
[[nodiscard]] bool differentiates_a_constant(const ExprTree& tree, const Equation& row,
                                             const std::vector<std::string>& uses);

/// Proved, with `uses`; nothing if no proof was found. `uses` names the laws that the proof needs, the
/// letters that it takes as constant (nothing on the page differentiates them), and those that must not be 0:
/// of the laws, not of the row. `ab = cb` says that a = c unless b is 0, whatever b is otherwise.
[[nodiscard]] std::optional<Judgement> prove_from(const RowUnderLaws& row, const Laws& set);

/// Does the row clearly fail where all these laws hold, at rough points? Then it is to be expected to follow
/// from no part of them either. Letters of the laws that the row does not have are not 0 there.
[[nodiscard]] bool fails_under(const RowUnderLaws& row, const Laws& set);

}  // namespace rigor
