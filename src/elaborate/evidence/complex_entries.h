// SPDX-License-Identifier: GPL-3.0-or-later
// What a written matrix shows of i and of complex letters.
#pragma once

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// `i` that faces itself across the diagonal is the unit, and V that faces V^* a complex number.
void see_complex_entries(const SyntaxTree& syntax, SyntaxId table, Evidence& evidence);

}  // namespace rigor
