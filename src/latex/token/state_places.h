// SPDX-License-Identifier: GPL-3.0-or-later
// Where kets, bras and their brackets end: `|n\rangle`, `\langle a|b\rangle`.
#pragma once

#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// Brackets of states in one another: to look for an end beyond them would take the square of a row's length.
inline constexpr int deepest_states = 50;

/// What `\langle` opens: the bars that belong to it, and its `\rangle`, or the number of tokens.
struct StateAngles {
  std::vector<std::size_t> bars;
  std::size_t close;
};
/// No bars for an average, `\langle x\rangle` and `\langle|x|\rangle`.
[[nodiscard]] StateAngles state_angles(TokenView tokens, std::size_t open);

/// The bars of `a|H|b`, outside of all brackets.
[[nodiscard]] std::vector<std::size_t> bars_of_states(TokenView content);

/// The place behind `|n\rangle`, whose bar is at `bar`; `bar` itself where that opens no ket.
[[nodiscard]] std::size_t behind_ket(TokenView tokens, std::size_t bar);

/// The same for a ket, and for a closed bracket of two states.
[[nodiscard]] std::size_t behind_states(TokenView tokens, std::size_t at);

/// `\left|n\right\rangle`, `\langle n\rvert`: has a bar with a side a bracket of a state for its partner?
[[nodiscard]] bool is_bar_of_one_state(TokenView tokens, std::size_t bar);

}  // namespace rigor
