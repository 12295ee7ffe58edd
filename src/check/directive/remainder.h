// SPDX-License-Identifier: GPL-3.0-or-later
// `+ O(x^n)` at the end of a side: up to which power of a letter the side is meant.
#pragma once

#include <optional>
#include <vector>

#include "latex/token/syntax.h"

namespace rigor {

struct Remainder {
  SyntaxId letter{};
  int power = 0;    // n, from 1
  SyntaxId rest{};  // the side without it: 0 where nothing else is there
  bool alone = false;
};

/// Of each side; nothing where none is added to it, more than one is, or the order is no whole number.
[[nodiscard]] std::vector<std::optional<Remainder>> remainders_of(SyntaxTree& syntax,
                                                                  const std::vector<SyntaxId>& sides);

}  // namespace rigor
