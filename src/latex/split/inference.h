// SPDX-License-Identifier: GPL-3.0-or-later
// Arrows between two equations of a line, `\Rightarrow` and its kind: which of them is inferred from the
// other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "latex/token/tokens.h"

namespace rigor {

/// How a stretch of a line hangs on those before it.
enum class Link : std::uint8_t {
  none,
  conclusion,   // `\Rightarrow`, `\therefore`, "hence"
  equivalence,  // `\iff`
  ground,       // `\Leftarrow`, `\because`: what comes first is inferred from this
  detail,       // "where", "with": it says what a letter is
};

struct LinkAt {
  Link link;
  std::size_t next;     // the place after it
  bool marked = false;  // something is written on the arrow, which may restrict it
};

/// Also `\to` with a wide space on both sides. Nothing for other signs.
[[nodiscard]] std::optional<LinkAt> link_at(TokenView tokens, std::size_t at);

/// Where a condition that begins at `begin` ends: at the next wide space, arrow or "then".
[[nodiscard]] std::size_t condition_end(TokenView tokens, std::size_t begin);
/// Does `Q = …` come next?
[[nodiscard]] bool opens_equation(TokenView tokens, std::size_t at);
/// Words at the left end of a line, before an equation: "where", `\text{for } x > 0, \quad`, "Second
/// method:".
[[nodiscard]] bool leads(TokenView line, const std::string& said, std::size_t next);

}  // namespace rigor
