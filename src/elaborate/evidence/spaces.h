// SPDX-License-Identifier: GPL-3.0-or-later
// "In two dimensions", "four-vectors", "curvilinear coordinates": the words speak of another space than that
// of three dimensions with its Cartesian axes.
#pragma once

#include <string_view>

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// Notes the first such words. `text`: prose with its formulas.
void see_spaces(std::string_view text, Evidence& evidence);

}  // namespace rigor
