// SPDX-License-Identifier: GPL-3.0-or-later
// What lints look through: the chains as they are written.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "check/event/notes.h"
#include "expr/tree/tree.h"

namespace rigor {

struct WrittenStatement {
  const ParsedChain* chain;
  bool displayed;  // in the notes, not in a directive
};

/// In the order of the notes; without cyclic images, whose signs are written only once.
[[nodiscard]] std::vector<WrittenStatement> statements_in(const Notes& notes);

/// A span that can be looked up: what was written and what it was read as are found by their place.
using Extent = std::tuple<FileId, std::uint32_t, std::uint32_t>;
[[nodiscard]] inline Extent extent_of(Span span) { return {span.file, span.begin, span.end}; }

}  // namespace rigor
