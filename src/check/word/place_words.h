// SPDX-License-Identifier: GPL-3.0-or-later
// Words that say a relation for one place or one moment. Its value there has no derivative. The lists are
// closed.
#pragma once

#include <string_view>

namespace rigor {

/// "There is no charge on the axis", "in the middle", "the fluid that touches the wall": a point, a line or a
/// surface; not "the force on the body", "depends on", "in the sphere".
[[nodiscard]] bool names_a_spot(std::string_view lead);
/// "The planet is closest to the sun if", "provided that": the display is what is asked for. These words are
/// the last ones.
[[nodiscard]] bool asks_directly(std::string_view lead);

}  // namespace rigor
