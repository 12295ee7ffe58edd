// SPDX-License-Identifier: GPL-3.0-or-later
// Why a step holds: one side turned into the other by small steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expr/question_names.h"

namespace rigor {

/// One small step: what stands now, and the rule in words that made it of what stood before.
struct SmallStep {
  ExprId expr{};
  std::string rule;     // `definition of ×`, `ε–δ`, `renamed dummy`, `Eq. (8)`, `first order in \delta`
  bool nearly = false;  // equal to first order only
};

/// start = steps[0] = steps[1] = …; each relation was proved by the exact side before it was put here.
struct Explanation {
  ExprId start{};
  std::vector<SmallStep> steps;         // the last one is the other side, unless there is a gap
  std::optional<std::string> gap = {};  // why the other side was not reached
};

/// The question's claim is an equation; its `tree` is not read. `tree` gets the expressions between.
/// Deterministic. A claim that the exact side does not prove has a gap and no steps.
[[nodiscard]] Explanation explain(ExprTree& tree, const Question& question, const QuestionNames& names);

}  // namespace rigor
