// SPDX-License-Identifier: GPL-3.0-or-later
// What is of second order in small quantities is left out.
#pragma once

#include <optional>
#include <span>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// Takes the terms with two or more small factors out, and terms that are of second order in a denominator.
/// `small`: symbols or components of them; their derivatives are as small as they are. Returns what was left
/// out, as an expression whose terms have two small factors each: the polynomial before is what is left plus
/// this. Nothing where a small quantity stands where its order cannot be seen (in a root, in a function,
/// alone in a denominator).
[[nodiscard]] std::optional<ExprId> without_second_order(ExprTree& tree, std::span<const ExprId> small,
                                                         IndexPolynomial& polynomial);

}  // namespace rigor
