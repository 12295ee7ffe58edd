// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace rigor {

/// What words beside an equation do to it.
enum class Remark : std::uint8_t {
  connective,  // "and", "therefore": another equation follows
  condition,   // "if", "with": the equation says something else, and is not judged
  no_sum,      // "no sum over i": repeated indices in it are not summed
  cyclic,      // "and cyclic permutations", "etc.": it is said for the other axes, too
  quantifier,  // "for all vectors": says what is taken for granted
  remark,      // names it, its parts or its source: nothing
  doubt,       // any other words: it may be proved, never refuted
};

/// English words; the equation's signs among them are not looked at.
[[nodiscard]] Remark remark_of(const std::string& words);

}  // namespace rigor
