// SPDX-License-Identifier: GPL-3.0-or-later
// First half of splitting a display: from tokens to rows of cells, without tags, labels, sizes and spacing
// arguments.
#pragma once

#include <string>
#include <vector>

#include "latex/token/accounting.h"
#include "latex/token/tokens.h"
#include "source/diagnostic.h"

namespace rigor {

struct Row {
  std::vector<Tokens> cells{1};  // what `&` separates; at least one
  std::string tag;               // `(6)` as it would be printed; empty: none
  Tokens in_tag;                 // what is in its braces
  std::string label;
  bool after_text = false;  // \intertext is above: no chain runs across
};

/// Rows of `aligned`, `split` and their kind inside the display become rows of the display, and so does a
/// `cases` that is a whole row (a system). `\left|` becomes the control `lvert`, `\left.` vanishes. Unmatched
/// environments are `unbalanced`.
[[nodiscard]] std::vector<Row> read_rows(TokenView tokens, Diagnostics& diagnostics, TokenUses& uses);

/// All tags, as they would be printed: what is known of a display that cannot be split. Cost: linear.
[[nodiscard]] std::vector<std::string> tags_in(TokenView tokens);

}  // namespace rigor
