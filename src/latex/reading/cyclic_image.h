// SPDX-License-Identifier: GPL-3.0-or-later
// What "and cyclic permutations" next to an equation says: the same with every axis replaced by the next one.
#pragma once

#include <optional>
#include <vector>

#include "latex/token/syntax.h"

namespace rigor {

/// What stands for axes in one equation.
struct WrittenAxes {
  bool letters = false;  // x, y, z: on a subscript, with a hat, or in a derivative
  bool hatted = false;   // \hat{i}, \hat{j}, \hat{k}
  bool dotless = false;  // written \hat{\imath}, \hat{\jmath}, \hat{k}
  /// Why the equation has no images: it has no axes, or a sign in it may be one or not. `place` is the sign.
  std::optional<Obstacle> obstacle = {};
  Span place = {};
};

/// The axes in all sides of an equation; no side is empty. Cost: linear in the sides.
[[nodiscard]] WrittenAxes axes_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides);

/// The expression with 1 → 2 → 3 → 1, x → y → z → x and i → j → k → i wherever they stand for axes: on
/// subscripts, as coordinates, as what a derivative is by, as unit vectors. Cost: linear in the expression.
[[nodiscard]] SyntaxId cyclic_image(SyntaxTree& syntax, SyntaxId root, const WrittenAxes& axes);

}  // namespace rigor
