// SPDX-License-Identifier: GPL-3.0-or-later
// What whole sentences around an equation, its tag or its heading say that may restrict it: "We neglect the
// mass of the rope." above it, "This holds at the surface only." after it, `\\tag{if $b = 0$}` next to it.
#pragma once

#include <optional>
#include <string>

#include "check/prose/prose.h"
#include "source/source_map.h"

namespace rigor {

struct SaidAround {
  std::string word;
  std::string where;      // "a sentence above it", "its tag"
  bool of_notes = false;  // "All systems in these notes are homogeneous": so are those of its laws
};

/// Of the display at `event`, for a row that is written `row` and has this tag. Cost: linear in the text of
/// its section.
[[nodiscard]] std::optional<SaidAround> said_around(const Prose& prose, std::size_t event,
                                                    const SourceMap& sources, Span row,
                                                    const std::string& tag);

}  // namespace rigor
