// SPDX-License-Identifier: GPL-3.0-or-later
// What a row would be proved from: what stands above it, holds where it stands, and shares a letter with it.
#pragma once

#include <vector>

#include "check/place/place.h"
#include "check/shown/read_row.h"
#include "expr/print/notation.h"

namespace rigor {

/// Definitions behind its letters first, then what is given and said, then laws, the likeliest first. At
/// most eight of each. Nothing is decided: a law may turn out to be refuted, and is then available to no row.
[[nodiscard]] std::vector<Ground> grounds_of(RowPlace& place, const ParsedChain& parsed,
                                             const Equation& equation, const Notation& notation);

}  // namespace rigor
