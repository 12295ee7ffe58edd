// SPDX-License-Identifier: GPL-3.0-or-later
// Notes with their verdicts as a document for pdflatex: amsmath, amssymb and graphics are enough. No macro of
// the author is needed, and what TeX could not set is shown as source. Long lines are cut at relations, then
// at + and −, and what is still too wide is made smaller, so that no box is overfull.
#pragma once

#include <string>
#include <vector>

#include "report/page/shown_notes.h"

namespace rigor {

/// `notes` is changed only by their macros being used. The same input gives the same bytes.
[[nodiscard]] std::string latex_document(std::vector<ShownNotes>& notes, SourceMap& sources);

}  // namespace rigor
