// SPDX-License-Identifier: GPL-3.0-or-later
// "the unit matrix $I$", "$E$ is the identity operator": a letter that is 1 among matrices or operators.
#pragma once

#include <string_view>

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// Adds the letters that the words call the unit matrix or the identity to `units`, and to what may not
/// commute with numbers in between. `text`: prose with its formulas.
void see_unit_matrices(std::string_view text, Evidence& evidence);

}  // namespace rigor
