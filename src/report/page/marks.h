// SPDX-License-Identifier: GPL-3.0-or-later
// What `rigor.sty` prints in the margin, display by display:
//
//   rigor-marks 2
//   absent notes.rigor
//   file 900150983cd24fb0d6963f7d28e17f72 notes.tex
//   display 12 14 proved 3 3
//
// The sidecar that would have been read if there were one. Every file that was read, a sidecar and one
// without displays, too, with the MD5 digest of its bytes; then its displays: first and last line, the worst
// that was found in it (`refuted`, `open`, `proved`, `given`; `silent` of one without steps), of how many
// steps, of how many in all. Paths are seen from the folder of the notes, which come first.
#pragma once

#include <string>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// `sources` has what was read for this file, and nothing else. The same bytes for the same report.
[[nodiscard]] std::string to_marks(const FileReport& file, const SourceMap& sources);

}  // namespace rigor
