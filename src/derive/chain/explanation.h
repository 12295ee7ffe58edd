// SPDX-License-Identifier: GPL-3.0-or-later
// Why a step holds: one side turned into the other by small steps.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "derive/chain/basis.h"
#include "expr/statement/question_names.h"
#include "expr/statement/statement.h"
#include "expr/statement/written_forms.h"

namespace rigor {

/// One small step: what stands now, and the rule in words that made it of what stood before.
struct SmallStep {
  ExprId expr{};
  std::string rule;     // `definition of ×`, `ε–δ`, `like terms collected`, `Eq. (8)`, `first order`
  bool nearly = false;  // equal to first order only
};

/// start = steps[0] = steps[1] = …; each relation was proved by the exact side before it was put here (a
/// `nearly` one: that what differs has two small factors in each term). Between vectors either all of them
/// are vectors, or all are components with one letter more (`letters`) than the claim has free indices.
struct Explanation {
  ExprId start{};
  std::vector<SmallStep> steps;         // the last one is the other side, unless there is a gap
  std::vector<IndexId> letters;         // of the components of a vector or tensor that are looked at
  std::optional<std::string> gap = {};  // why the other side was not reached
  bool by_cases = false;                // the last resort: component by component
};

/// The question's claim is an equation; its `tree` is not read. `tree` gets the expressions between. What is
/// `known` is used where it makes the chain shorter. Deterministic. A claim that the exact side does not
/// prove has a gap and no steps. Bounded: some hundred small decisions.
[[nodiscard]] Explanation explain(ExprTree& tree, const Question& question, const QuestionNames& names,
                                  std::span<const KnownEquation> known = {});
/// To first order in what is small.
[[nodiscard]] Explanation explain(ExprTree& tree, const NearlyQuestion& question);

/// The step between forms `step` and `step` + 1 of a chain, with the tagged equations before it known. One
/// that was not proved has a gap that says so.
[[nodiscard]] Explanation explain_step(WrittenForms& forms, std::size_t chain, std::size_t step);

}  // namespace rigor
