// SPDX-License-Identifier: GPL-3.0-or-later
// One side of a relation, from tokens to the syntax tree.
#pragma once

#include "latex/token/choices.h"
#include "latex/token/syntax.h"
#include "latex/token/tokens.h"

namespace rigor {

/// How deep brackets may nest; more is `nesting_too_deep`. The recursion of every later pass is bounded by
/// this.
inline constexpr int max_nesting = 200;

/// Always gives a node. What cannot be read is an opaque node with its reason and place; the rest of the side
/// is read all the same. Products: juxtaposition, `\cdot`, `\times` and `/` are kept in a row as written
/// (SyntaxKind::term); precedence is a matter of meaning.
/// `\sum`, `\int` and operators such as `\frac{d}{dt}` take the rest of their term, `\partial_i` the next
/// factor, `\cos` without a bracket the plain letters and numbers that follow. `choices` says which way to go
/// where there are two; without it the first one is taken. Cost: linear in the tokens, times the nesting.
[[nodiscard]] SyntaxId parse_side(TokenView tokens, Span place, SyntaxTree& tree, Choices* choices = nullptr);

}  // namespace rigor
