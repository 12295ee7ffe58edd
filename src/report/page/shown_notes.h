// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as a document shows them: headings and equations in their order, each equation with its steps.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "check/step/report.h"
#include "latex/layout/layout.h"
#include "latex/macro/macros.h"
#include "report/wording/worked_step.h"
#include "source/source_map.h"

namespace rigor {

struct ShownHeading {
  int level = 1;
  std::string title;       // as written
  std::size_t macros = 0;  // see `ShownNotes`
};

/// A display, or a statement of a directive.
struct ShownEquation {
  Span span;
  bool displayed = true;              // false: a directive says it
  std::string source;                 // of a display: what is between its delimiters, as written
  std::optional<ShownDisplay> shown;  // of a display; nothing where its macros never end
  std::vector<const Step*> steps;     // of the report
  std::size_t macros = 0;             // see `ShownNotes`; what the display itself defines is in force
};

using ShownItem = std::variant<ShownHeading, ShownEquation>;

struct ShownNotes {
  const FileReport* report = nullptr;
  std::vector<ShownItem> items;
  std::vector<MacroTable> macros;            // in force at one item or another, which has its number
  std::vector<WorkedStep> derivations = {};  // of steps, where they were asked for
};

/// `report` was made of a file in `sources`, and outlives the answer. Displays without a step are there, too.
/// A step that a directive states is before the next display that comes after it in the report. Cost:
/// reading the notes again.
[[nodiscard]] ShownNotes show_notes(SourceMap& sources, const FileReport& report);

/// Must somebody look at the step: is it refuted and not expected to be, or the reverse, open, or malformed?
[[nodiscard]] bool needs_attention(const Step& step);

/// The mark of a verdict: `✓`.
[[nodiscard]] std::string_view sign_of(Verdict verdict);
/// `not understood`; `refuted, as expected`.
[[nodiscard]] std::string verdict_words(const Step& step);

/// `definition I_{ij} (8)`, taken apart.
struct Use {
  std::string word;   // `definition`, `let`, `given`, `convention`
  std::string latex;  // what; empty: `place` says all
  std::string place;  // `(8)`, `line 312`, or words
};
[[nodiscard]] Use use_of(const std::string& text);

}  // namespace rigor
