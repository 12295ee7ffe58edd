// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/lint/lint.h"

#include <algorithm>
#include <array>

#include "check/lint/lint_scopes.h"

namespace rigor {
namespace {

bool lies_in(Span inner, Span outer) {
  return inner.file == outer.file && inner.begin >= outer.begin && inner.end <= outer.end;
}

/// The first step that the place is part of. What a directive says is reported elsewhere than it stands.
Step* step_at(const LintInput& input, Span place, FileReport& report) {
  for (const StatedEquation& stated : input.stated) {
    const Span both = cover(input.tree[stated.left].span, input.tree[stated.right].span);
    if (lies_in(place, both)) return &report.steps[stated.step];
  }
  const auto found =
      std::ranges::find_if(report.steps, [&](const Step& step) { return lies_in(place, step.span); });
  return found == report.steps.end() ? nullptr : &*found;
}

struct Lint {
  DiagnosticKind kind;
  Findings (*find)(const LintInput&);
  bool certain = false;  // may be sure of being wanted though it is off
};

constexpr std::array lints{Lint{DiagnosticKind::two_meanings, lint_meanings},
                           Lint{DiagnosticKind::shared_letter, lint_letters},
                           Lint{DiagnosticKind::mixed_spelling, lint_spelling},
                           Lint{DiagnosticKind::plain_vector, lint_faces},
                           Lint{DiagnosticKind::hidden_index, lint_subscripts},
                           Lint{DiagnosticKind::idle_sum, lint_sums},
                           Lint{DiagnosticKind::near_name, lint_names},
                           Lint{DiagnosticKind::repeated_side, lint_repeats},
                           Lint{DiagnosticKind::mixed_frames, lint_frames},
                           Lint{DiagnosticKind::scalar_zero, lint_zeros, true},
                           Lint{DiagnosticKind::mixed_parity, lint_parity},
                           Lint{DiagnosticKind::unused_definition, lint_definitions}};

}  // namespace

void lint(const LintInput& input, const LintScopes& scopes, FileReport& report) {
  for (const Lint& each : lints) {
    const bool off = info(each.kind).off;
    if (off && !each.certain && !scopes.asks_somewhere(each.kind)) continue;
    for (Finding& finding : each.find(input)) {
      const Span place = finding.diagnostic.span;
      if (off && !finding.certain && !scopes.asks_for(each.kind, place)) continue;
      Step* step = step_at(input, place, report);
      (step != nullptr ? step->diagnostics : report.diagnostics).push_back(std::move(finding.diagnostic));
    }
  }
}

}  // namespace rigor
