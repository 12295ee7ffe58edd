// SPDX-License-Identifier: GPL-3.0-or-later
// What a page rests on: the laws that it states, and how many steps use each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

struct LawUse {
  std::string name;        // as `uses` has it: `law (3)`, `law in line 12`
  Span span;               // of its first step
  std::uint32_t used = 0;  // steps that name it
};

/// In the order of the notes. Laws of one tag are one entry; rows that restate a law are none. A conclusion
/// of which no proof was found is one where others would follow from it.
[[nodiscard]] std::vector<LawUse> laws_of(const FileReport& file, const SourceMap& sources);

/// `rests on 3 laws: (1.2), used by 4 steps; line 30, by 1; 1 other by none`; empty if it states none.
[[nodiscard]] std::string print_laws(const std::vector<LawUse>& laws);

}  // namespace rigor
