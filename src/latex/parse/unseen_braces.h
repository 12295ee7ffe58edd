// SPDX-License-Identifier: GPL-3.0-or-later
// Braces of LaTeX that act as brackets and are not seen: of `a - {b - c}` and `{2b}^2` a reader sees
// a − b − c and 2b².
#pragma once

#include "latex/token/tokens.h"

namespace rigor {

/// Does the group at `at`, which is nobody's argument, hold together what a reader sees apart? Not one symbol
/// or one bracket, nor a sum or a product between signs where it may stand without the braces. Cost: linear.
[[nodiscard]] bool groups_unseen(TokenView tokens, std::size_t at);

/// `{x^2}^3`, which a reader sees as x²³.
[[nodiscard]] bool stacks_powers(TokenView tokens, std::size_t at);

/// Is there a sum of several terms in it? Of `\cos{\omega t + \alpha}` a reader sees cos ωt + α.
[[nodiscard]] bool holds_unseen_sum(TokenView tokens, std::size_t at);

/// Blanks take the place of braces that only set spaces or hold nothing, `a{+}b`, `\exp{}(x)`, `x_{}`, and of
/// the sign of an empty script, so that no token moves. Cost: linear.
void lift_idle_braces(Tokens& tokens);

}  // namespace rigor
