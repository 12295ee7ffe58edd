// SPDX-License-Identifier: GPL-3.0-or-later
// A defined symbol replaced by what it stands for.
#pragma once

#include "expr/statement/statement.h"

namespace rigor {

/// The expression with the definition put in for its symbol everywhere; the same id where it does not occur,
/// or only as a whole although it is defined by its components. The square of √x is written x.
[[nodiscard]] ExprId unfolded(ExprTree& tree, ExprId root, const Definition& definition);

/// A component, taken of each term and factor by itself: (Σ_α m_α r_α)_i is Σ_α m_α r_αi.
[[nodiscard]] ExprId component_within(ExprTree& tree, ExprId id, const std::vector<Slot>& slots);

/// The expression with its free letters replaced.
[[nodiscard]] ExprId with_slots(ExprTree& tree, ExprId root, const std::vector<IndexId>& variables,
                                const std::vector<Slot>& by);
[[nodiscard]] ExprId with_particle(ExprTree& tree, ExprId root, ParticleId variable, ParticleId by);

}  // namespace rigor
