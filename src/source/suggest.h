// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rigor {

/// Edits (insert, delete, replace, exchange of neighbours) from one word to the other, at most `limit + 1`.
/// Source: Damerau–Levenshtein, optimal string alignment. Cost: O(|a| |b|), less where they are far apart.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The nearest of `known` to `word`, if it is within a third of the word's length (at least one edit) and not
/// every letter differs (`y` is no suggestion for `x`); the first of equals. A word of more than 128 bytes is
/// no slip of the pen.
[[nodiscard]] std::optional<std::string> suggest(std::string_view word, std::span<const std::string> known);

}  // namespace rigor
