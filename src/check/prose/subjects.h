// SPDX-License-Identifier: GPL-3.0-or-later
// What the words before a row say that it speaks of: another case, another thing, things that commute. The
// lists are closed.
#pragma once

#include <cstddef>
#include <string_view>

#include "check/prose/prose.h"

namespace rigor {

/// "In an incompressible fluid, this reduces to", "For the second wire": a sentence that begins by saying of
/// what it speaks. "For this", "In general" and "With (3)" say nothing of the kind.
[[nodiscard]] bool begins_with_a_case(std::string_view lead);

/// "With two such coils", "The beam that is clamped has therefore", "Electrons": the words before the row,
/// since the last display, begin with what they speak of, and not with "hence", "it" or "this".
[[nodiscard]] bool brings_in_a_subject(std::string_view lead);

/// Do words of the section say that matrices or operators may be multiplied in any order?
[[nodiscard]] bool speaks_of_any_order(const Prose& prose, std::size_t event, std::string_view heading);

}  // namespace rigor
