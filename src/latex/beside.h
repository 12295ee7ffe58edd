// SPDX-License-Identifier: GPL-3.0-or-later
// Where a remark such as "(no sum over i)" ends, and where the next equation begins without a wide space.
#pragma once

#include <cstddef>
#include <string>

#include "latex/tokens.h"

namespace rigor {

/// The words with what stands between them, without the controls around them.
[[nodiscard]] std::string spoken(TokenView tokens);

/// `\text{no sum over }i`: the place behind the letters that belong to the words.
[[nodiscard]] std::size_t remark_end(TokenView tokens, const Argument& words);

/// `a_i = b_i \; (\text{no sum})`: the place behind a bracket at `at` that holds only "no sum" or "and cyclic
/// permutations"; `at` itself for any other.
[[nodiscard]] std::size_t bracketed_remark_end(TokenView tokens, std::size_t at);

/// `\dot\omega_1 = a~\dot\omega_2 = b`: behind a visible space, the dotted letter that `before` begins with
/// begins the next equation.
[[nodiscard]] bool begins_next_dotted(TokenView before, TokenView tokens, std::size_t at);

}  // namespace rigor
