// SPDX-License-Identifier: GPL-3.0-or-later
// Lints: what was read, and is perhaps not what was meant. Each looks at the whole file after its steps have
// their verdicts, changes none of them, and says nothing where it is not sure.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "check/event/notes.h"
#include "check/step/report.h"
#include "expr/tree/tree.h"

namespace rigor {

class LintScopes;

/// A relation whose two sides were read.
struct StatedEquation {
  ExprId left{};
  ExprId right{};
  Span relation;
  RelationKind kind = RelationKind::equal;
  bool by_notes = false;  // in a display or a `claim`: no assumption, and no `let`
  bool passing = false;   // what holds for the next statement only
  std::size_t step = 0;   // of the report
  [[nodiscard]] bool is_equation() const {
    return kind == RelationKind::equal || kind == RelationKind::identical || kind == RelationKind::defines;
  }
};

struct LintInput {
  const SourceMap& sources;
  const Notes& notes;
  const ExprTree& tree;
  const std::vector<StatedEquation>& stated;  // in the order of the notes; without cyclic images
  const FileReport& report;
  const std::map<SymbolId, bool>& mirrored;  // declared: does it change its sign in a mirror?
};

/// What a lint found. A finding of a kind that is off by default can be `certain` of being wanted.
struct Finding {
  Diagnostic diagnostic;
  bool certain = false;
};
using Findings = std::vector<Finding>;

Findings lint_meanings(const LintInput& input);     // two-meanings
Findings lint_letters(const LintInput& input);      // shared-letter
Findings lint_spelling(const LintInput& input);     // mixed-spelling
Findings lint_faces(const LintInput& input);        // plain-vector
Findings lint_subscripts(const LintInput& input);   // hidden-index
Findings lint_sums(const LintInput& input);         // idle-sum
Findings lint_names(const LintInput& input);        // near-name
Findings lint_repeats(const LintInput& input);      // repeated-side
Findings lint_frames(const LintInput& input);       // mixed-frames
Findings lint_zeros(const LintInput& input);        // scalar-zero
Findings lint_parity(const LintInput& input);       // mixed-parity
Findings lint_definitions(const LintInput& input);  // unused-definition

/// Adds all findings that are wanted where they stand to `report`, which `input` refers to: to the step that
/// they are in, if there is one.
void lint(const LintInput& input, const LintScopes& scopes, FileReport& report);

}  // namespace rigor
