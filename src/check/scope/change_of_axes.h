// SPDX-License-Identifier: GPL-3.0-or-later
// What is said along fixed axes, said along turning ones, and back. Components along the turning axes are
// Rᵀ A of those along the fixed axes, with the rotation R of `frame`, which is 1 at the moment that is looked
// at and changes at the rate Ṙ = R Ω, Ω_ij = −ε_ijk ω_k.
#pragma once

#include <optional>

#include "elaborate/name/names.h"
#include "expr/calculus/differentiate.h"

namespace rigor {

/// What is turned by which rotation. Where derivatives are too large, the budget is exceeded and the result
/// is not right. `used` gets the directives that say how what is turned changes.
struct Turning {
  ExprTree& tree;
  const Names& names;
  SymbolId rotation;
  Directives& used;
  DerivativeBudget budget = {};
};

/// What held along fixed axes before a frame. A covariant statement keeps its form but for rates, which
/// become Rᵀ d(RA)/dt (for each axis of a tensor one R); in any other A becomes R A, and what is defined
/// Rᵀ of the body. Both hold at all times. What cannot be turned so (a gradient's components) is marked as
/// said at one instant.
[[nodiscard]] Held along_turning_axes(Turning& turning, const Held& before);

/// A vector or tensor that was declared constant before is constant along the fixed axes: an assumption.
[[nodiscard]] NamedAssumption constant_along_fixed_axes(Turning& turning, const DeclaredConstant& constant);

/// A definition that was made in a frame, for after it: R is 1, and the rate along the turning axes is
/// dA/dt − ω×A. What is not covariant holds at the moment only. Nothing where R was differentiated three
/// times or more, or a derivative is too large.
[[nodiscard]] std::optional<NamedDefinition> along_fixed_axes(ExprTree& tree, const Names& names,
                                                              const Frame& frame, NamedDefinition made,
                                                              Directives& used);

}  // namespace rigor
