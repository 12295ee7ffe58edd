// SPDX-License-Identifier: GPL-3.0-or-later
// Where a display ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "latex/text/document_text.h"
#include "latex/token/environments.h"

namespace rigor {

enum class DisplayDelimiter : std::uint8_t {
  dollars,         // $$ … $$
  bracket,         // \[ … \]
  double_bracket,  // \\[ … \\], in Markdown
  environment,     // \begin{align} … \end{align}
};

struct DisplayEnd {
  enum class Outcome : std::uint8_t {
    closed,  // by [begin, end)
    wrong,   // [begin, end) is the end of an environment that was not opened here
    open,    // no end before `begin`, where something starts that cannot be in a display
  };
  Outcome outcome = Outcome::open;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::optional<std::size_t> passed = {};  // where a first display opens in the words of an \intertext
};

/// Looks for the end from `from` on, after the opening, and before `limit`. Without one, the search stops at
/// the next display or heading, and for `$$` in LaTeX at a blank line. In Markdown `$$` and `\[` go on after
/// a blank line where mathematics does; they are open there where words follow, and where a later `$$` can
/// just as well be the opening of another display. Displays in the words of an \intertext are passed over.
/// Cost: linear in what it passes over, and up to the next `$$`.
[[nodiscard]] DisplayEnd find_display_end(const NotesText& text, const EnvironmentAliases& aliases,
                                          DisplayDelimiter delimiter, std::string_view environment,
                                          std::size_t from, std::size_t limit);

/// The level of a LaTeX heading (`section`): 0 for \part, 1 for \chapter and so on; negative for other
/// controls.
[[nodiscard]] int heading_rank(std::string_view control);
/// Markdown: the level of `## Title` that starts the line; 0 for other lines.
[[nodiscard]] int atx_level(const NotesText& text, std::size_t line);

}  // namespace rigor
