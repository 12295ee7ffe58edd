// SPDX-License-Identifier: GPL-3.0-or-later
// One statement's tokens: several equations on a line, tags in brackets, remarks and conditions told apart.
#pragma once

#include <cstddef>
#include <vector>

#include "latex/split/split.h"
#include "latex/token/accounting.h"

namespace rigor {

/// The chains of `a = b \quad\text{or}\quad c = d, e = f \quad (6)`.
[[nodiscard]] std::vector<WrittenChain> split_statement(TokenView tokens, TokenUses& uses);

/// The first place at or after `at` that is neither blank nor spacing; the size at the end.
[[nodiscard]] std::size_t first_significant(TokenView tokens, std::size_t at);
/// `\overset{!}{=}`, `\stackrel{\text{def}}{=}`: is there a relation with something written on it?
[[nodiscard]] bool is_stacked_relation(TokenView tokens, std::size_t at);
/// Is there a relation outside all brackets?
[[nodiscard]] bool has_relation(TokenView tokens);
/// `i = j`, `(i \ne j)`: bare index letters on both sides, so a condition on the equation next to it.
[[nodiscard]] bool relates_index_letters(TokenView tokens);
/// Does it end in a relation or an operator, so that more must follow?
[[nodiscard]] bool ends_open(TokenView tokens);

}  // namespace rigor
