// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace rigor {

/// What words beside an equation do to it.
enum class Remark : std::uint8_t {
  connective,  // "and", "therefore": another equation follows
  condition,   // "if", "no sum": the equation says something else, and is not judged
  quantifier,  // "for all vectors": says what is taken for granted
  remark,      // names it, its parts or its source: nothing
  doubt,       // any other words: it may be proved, never refuted
};

/// English words; the equation's signs among them are not looked at.
[[nodiscard]] Remark remark_of(const std::string& words);

}  // namespace rigor
