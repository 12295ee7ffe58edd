// SPDX-License-Identifier: GPL-3.0-or-later
// When an equation holds: `\text{for } x > 0` next to it, `\tag{if $b = 0$}`, `\underbrace{X}_{0}` in it.
// Only what is read to its last token is a condition; the words are a closed list that docs/notation.md
// shows.
#pragma once

#include <optional>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// `x > 0`, `(x, y > 0)`, `a \ne b \text{ and } b < c`: one stretch for each relation, `x > 0` and `y > 0`
/// for `x, y > 0`. Relations of indices, `i \ne j`, do not count.
[[nodiscard]] std::optional<std::vector<Tokens>> conditions_in(TokenView tokens);

/// The same after "if", "for", "when", "provided that", …: `\text{if } x > 0`, `\text{for $x > 0$}`. After
/// "where" and "with" it is an order, since an equation there defines a letter.
[[nodiscard]] std::optional<std::vector<Tokens>> conditions_behind_words(TokenView tokens);

/// Of what is in `\tag{…}`: `for $x > 0$`, `3, $x > 0$`.
[[nodiscard]] std::optional<std::vector<Tokens>> conditions_in_tag(TokenView tokens);

/// `m, k`: each of the symbols; none where something else is there.
[[nodiscard]] std::vector<Tokens> listed_letters(TokenView tokens);

/// What `\underbrace{part}_{label}` says: `part = 0` for `0`, `part > 0` for `> 0`, `part = Y` for `= Y`.
[[nodiscard]] std::optional<Tokens> said_at_brace(TokenView part, TokenView label);

/// Of all braces in a side, also in those within brackets and arguments.
[[nodiscard]] std::vector<Tokens> said_at_braces(TokenView side);

}  // namespace rigor
