// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "latex/token/syntax.h"
#include "latex/token/tokens.h"

namespace rigor {

struct IndexReading {
  std::vector<WrittenIndex> indices;
  std::optional<Obstacle> obstacle;
};

/// The contents of a subscript: `ijk`, `\alpha i`, `i'j`, `12`, `\text{rot}`, `cm`. A comma, a sign or a bold
/// letter is an obstacle.
[[nodiscard]] IndexReading read_indices(TokenView tokens);

/// The label that stands above a letter: `^{(0)}` of `(0)`, `^{\text{lab}}` of `\mathrm{lab}`. Nothing for
/// what can be a power, an index, a transpose or a conjugate.
[[nodiscard]] std::optional<WrittenIndex> read_upper_label(TokenView tokens);

/// The contents of a sum's subscript: `i`, `i=1`, `i,j`, `\alpha`; conditions such as `i<j` are obstacles.
struct SumReading {
  WrittenSum sum;
  std::optional<Obstacle> obstacle;
};
[[nodiscard]] SumReading read_sum_bounds(TokenView lower, TokenView upper);

}  // namespace rigor
