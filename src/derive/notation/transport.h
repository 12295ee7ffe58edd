// SPDX-License-Identifier: GPL-3.0-or-later
// The transport theorem as a rule: a derivative in the fixed frame is the one in the rotating frame and ω×A.
#pragma once

#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// What a frame's definitions say: R is 1, Ṙ is R turned with `angular_velocity`.
struct TurningFrame {
  SymbolId rotation{};
  SymbolId rate{};
  ExprId angular_velocity{};
};

[[nodiscard]] std::vector<TurningFrame> turning_frames(ExprTree& tree, const Question& question);

/// Rᵀ(ṘA + RȦ) as Ȧ + ω×A everywhere; the same id where it does not occur.
[[nodiscard]] ExprId transported(ExprTree& tree, ExprId root, const TurningFrame& frame);

}  // namespace rigor
