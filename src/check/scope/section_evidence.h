// SPDX-License-Identifier: GPL-3.0-or-later
// What a section of the notes shows of its letters, in its equations and in its words.
#pragma once

#include <cstddef>
#include <optional>

#include "check/event/notes.h"
#include "elaborate/evidence/evidence.h"
#include "source/source_map.h"

namespace rigor {

/// Of the section whose heading is event `heading`, up to the next heading, and of the sections around it;
/// without one, of what comes before the first heading. `without`: the chain there shows nothing. Cost:
/// linear in these sections.
[[nodiscard]] Evidence evidence_of_section(const SourceMap& sources, const Notes& notes,
                                           std::optional<std::size_t> heading,
                                           std::optional<Span> without = {});

}  // namespace rigor
