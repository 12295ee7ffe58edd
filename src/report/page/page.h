// SPDX-License-Identifier: GPL-3.0-or-later
// Notes with their verdicts as one HTML page: no network, no font, script and style inside, mathematics as
// MathML. What is in the notes cannot leave its element. The same input gives the same bytes.
#pragma once

#include <string>
#include <vector>

#include "check/shown/read_row.h"
#include "report/page/shown_notes.h"
#include "report/text/eval_text.h"

namespace rigor {

/// One file of notes and all that is known of it.
struct PageNotes {
  ShownNotes shown;
  std::string link;  // from the page to the notes, as a relative path; empty: there is none
  const NotesReading* reading = nullptr;  // how the rows were read, where the page is to say so
  EvaluatedNotes
      evaluated;  // empty where forms were not evaluated; read from the same text, perhaps a second time
};

/// `notes` is changed only by their macros being used. Everything in it belongs to `sources`.
[[nodiscard]] std::string html_page(std::vector<PageNotes>& notes, SourceMap& sources);

}  // namespace rigor
