// SPDX-License-Identifier: GPL-3.0-or-later
// What words before a row say is held: "At constant temperature", "keeping $p$ fixed", "in an isothermal
// expansion".
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace rigor {

struct HeldByWords {
  std::set<std::size_t> maths;  // `$` of the text, counted from 0
  std::set<std::string> nouns;  // "temperature", in the singular
};

/// `text`: the words before a display, as in `ProseBeside`, without those before an earlier display. Nothing
/// where they deny something, or say it of a supposed case.
[[nodiscard]] HeldByWords held_by_words(std::string_view text);

/// Which `$` of a sentence the words call so: "$T$ is the absolute temperature", "the temperature $T$".
[[nodiscard]] std::optional<std::size_t> maths_called(std::string_view sentence, std::string_view noun);

}  // namespace rigor
