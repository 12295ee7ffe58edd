// SPDX-License-Identifier: GPL-3.0-or-later
// A half-open range of bytes in one source file: the place of everything that Rigor says.
#pragma once

#include <algorithm>
#include <cstdint>

namespace rigor {

using FileId = std::uint32_t;

struct Span {
  FileId file = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  [[nodiscard]] constexpr bool empty() const { return begin == end; }
  friend constexpr bool operator==(const Span&, const Span&) = default;
};

/// The smallest span that covers both; where the files differ, the first wins.
[[nodiscard]] constexpr Span cover(Span first, Span second) {
  if (first.file != second.file) return first;
  return {first.file, std::min(first.begin, second.begin), std::max(first.end, second.end)};
}

}  // namespace rigor
