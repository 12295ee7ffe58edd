// SPDX-License-Identifier: GPL-3.0-or-later
// A bold face over an expression, `\mathbf{a\times b}`, is the face of each of its letters; so is `**A**` in
// Markdown, which some editors show bold inside mathematics as well.
#pragma once

#include "latex/token/tokens.h"

namespace rigor {

/// `{\mathbf{a}\times\mathbf{b}}` for `\mathbf{a\times b}`: digits, signs, brackets and subscripts stay as
/// they are. Only for products and sums of single letters: two letters side by side, a relation or a fraction
/// may be set bold to be noticed, and are left alone.
[[nodiscard]] Tokens with_faces_spread(Tokens tokens);

/// `\mathbf{A}` for `**A**`. Stars between two operands, `x**2`, are no face.
[[nodiscard]] Tokens with_starred_faces(Tokens tokens);

}  // namespace rigor
