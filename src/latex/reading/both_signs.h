// SPDX-License-Identifier: GPL-3.0-or-later
// `\pm` and `\mp` on both sides of each relation: two statements, one with the upper signs and one with the
// lower ones. On one side alone they say that something is one of two values, or how exactly it was measured.
// `r_{1,2} = a \pm b` names the two: r_1 has the upper sign and r_2 the lower one.
#pragma once

#include "latex/split/split.h"

namespace rigor {

[[nodiscard]] bool is_two_statements(const WrittenChain& chain);
/// The statement of the upper or the lower signs, with the first or the second label of each pair; the tokens
/// keep their places.
[[nodiscard]] WrittenChain with_signs(WrittenChain chain, bool upper);

}  // namespace rigor
