// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of the page: text, mathematics, the details of a step, forms.
#pragma once

#include <string>
#include <string_view>

#include "latex/layout/mathml.h"
#include "report/page/notes_math.h"
#include "report/page/page.h"

namespace rigor {

/// What all pieces of one file need.
struct PageContext {
  SourceMap& sources;
  NotesMath& math;
  const std::string& link;  // to the notes; empty: there is none
  FileId file = 0;          // which `link` leads to
  const std::vector<WorkedStep>& derivations;
  const NotesReading* reading;  // nothing: the page does not say how rows were read
};

/// The whole <style> and <script>.
[[nodiscard]] std::string_view page_style();
[[nodiscard]] std::string_view page_script();

/// LaTeX of a report as MathML; as code where it cannot be read.
[[nodiscard]] std::string math_html(const PageContext& page, const std::string& latex, MathStyle style);
/// A line with mathematics between dollar signs.
[[nodiscard]] std::string line_html(const PageContext& page, const std::string& prose);
/// A message: what is between back-ticks is code.
[[nodiscard]] std::string message_html(std::string_view message);
/// `notes.md:12`, as a link if the page has one to the notes.
[[nodiscard]] std::string place_html(const PageContext& page, Span span);

/// One entry of a list of terms.
[[nodiscard]] std::string term_html(std::string_view term, std::string_view what);
/// `definition I_{ij} (8)`, with its mathematics.
[[nodiscard]] std::string use_html(const PageContext& page, const std::string& text);

/// How the row of a step was read, folded away; nothing for a cyclic image. What the step shows anyway, its
/// equation and why it is not read, is left out.
[[nodiscard]] std::string reading_html(const PageContext& page, const Step& step);

/// What the line of a step shows next to its verdict.
enum class StepLine : std::uint8_t {
  gist,      // how, or what is wrong: its equation is the whole display
  relation,  // the relation and the right side: it is one of several in the display
  equation,  // both sides: there is no display
};

/// <li>: the step's verdict, and all that is known of it behind a click.
[[nodiscard]] std::string step_html(const PageContext& page, const Step& step, StepLine line);

/// Behind a click: time against error of the forms of a chain, and which to compute. `number` sets the
/// picture's ids apart.
[[nodiscard]] std::string forms_html(const PageContext& page, const EvaluatedChain& evaluated,
                                     std::size_t number);

/// A diagnostic of a step or of the file.
[[nodiscard]] std::string diagnostic_html(const PageContext& page, const Diagnostic& diagnostic);

}  // namespace rigor
