// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensions of one file: every symbol's, and the places where two of them disagree.
//
// Sources, in the order of the notes: what `units` declares; then laws, definitions, assumptions, and what is
// undecided. Compared with these are claims made by directives, and what is refuted, unless that was
// expected. What is proved is true whatever its letters stand for: it only has to agree with what `units`
// says of them.
//
// Without `units` every symbol could be a number, and nothing contradicts anything. Then the time is taken
// for a quantity of its own, unless some statement alone makes a number of it, as `\dot x = x` does; what
// disagrees with that is a warning, and never said of what is proved. So is a number where a quantity is
// declared, whose unit can be left out.
#pragma once

#include "check/dimension/dimension_record.h"
#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// Adds diagnostics to the steps and the file, and the table of dimensions. All verdicts are known.
void solve_dimensions(const DimensionRecord& record, const SourceMap& sources, FileReport& report);

}  // namespace rigor
