// SPDX-License-Identifier: GPL-3.0-or-later
// Which ranks what was written can have, over all readings of its letters. `\mathbf F = ma` can be meant with
// `a` for a vector, `\mathbf A\times\mathbf B = m\,\mathbf A\cdot\mathbf B` with no `m`: only of the latter
// is it certain that a rank is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elaborate/name/letters.h"
#include "elaborate/name/names.h"
#include "latex/token/syntax.h"

namespace rigor {

/// Bit r: rank r is possible, for r from 0 to 3.
using RankSet = std::uint8_t;
inline constexpr RankSet no_rank = 0;
inline constexpr RankSet any_rank = 0b1111;

/// What nothing in the row or the section settles.
struct OpenPart {
  Span span;
  std::string doubt;  // "`a` can be a vector"
};

/// Reads with `letters`, and with the evidence of the section in `names`. `open` gets what was not settled,
/// in the order of the text. The set is empty only where no reading has a rank. Cost: linear in the nodes,
/// times 256 for products.
[[nodiscard]] RankSet possible_ranks(const SyntaxTree& syntax, SyntaxId id, const Letters& letters,
                                     const Names& names, std::vector<OpenPart>& open);

}  // namespace rigor
