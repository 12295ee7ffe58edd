// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of notes for the floating-point side: their chains as they were written, and expressions that are
// asked for in the notes' own letters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/form/holes.h"
#include "check/step/report.h"
#include "expr/statement/written_forms.h"
#include "source/source_map.h"

namespace rigor {

struct FormRequest {
  std::vector<std::string> asked = {};   // LaTeX: `T_{rot}`, `(\Omega_2)^2`, with the notes' macros
  std::optional<std::string> at = {};    // a tag or a heading: asked for after it; nothing: at the end
  std::optional<std::string> sidecar{};  // without it, `NAME.rigor` next to the notes, if there is one
  /// Tags or headings. Given, only these chains, and those that define what they or the asked need, are
  /// elaborated, and nothing is decided but whether a name gets a second meaning. Nothing: all chains, each
  /// step decided.
  std::optional<std::vector<std::string>> only = {};
  std::optional<std::string> statement = {};  // a display more, after `at`
  bool answer_holes = false;                  // what `\square` may be is looked for
};

struct FormsReading {
  std::vector<WrittenHole> holes = {};
  FileReport report;  // of what was elaborated; without lints and dimensions if `only` was given
  WrittenForms forms = {};
  std::optional<FileId> statement = {};
  std::vector<FileId> asked = {};      // what was asked, one text each: diagnostics point into them
  std::size_t chains_passed_over = 0;  // that nothing asked for needs
};

}  // namespace rigor
