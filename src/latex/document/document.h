// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to its items.
#pragma once

#include "latex/text/format.h"
#include "latex/text/items.h"
#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

/// Reads a file that is already in `sources` (and mended). `\input{x}` and `\include{x}` (LaTeX) are followed
/// inside the folder of the notes and below, at most 16 deep, each file once; a file outside is
/// `input_outside`, a missing one `missing_input`. What is opened and not closed is `unbalanced`, and reading
/// goes on after the next blank line. Cost: linear in the text.
[[nodiscard]] Document read_document(SourceMap& sources, FileId file, Diagnostics& diagnostics);

}  // namespace rigor
