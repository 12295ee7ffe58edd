// SPDX-License-Identifier: GPL-3.0-or-later
// `\square` and `\Box` have two meanings, and their form says which: directly before an operand, as in
// `\Box\psi` and `(\square + m^2)\phi`, they are d'Alembert's operator; alone, or with a space or a sign of
// multiplication after, as in `\square\,\psi`, they are a hole.
#pragma once

#include <cstddef>

#include "latex/token/tokens.h"

namespace rigor {

/// The factor in [begin, end) is a box, a power of one, or a bracket with a box as a term, and an operand
/// follows directly.
[[nodiscard]] bool is_box_operator(TokenView tokens, std::size_t begin, std::size_t end);

}  // namespace rigor
