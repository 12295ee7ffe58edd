// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/step/report.h"

namespace rigor {

std::string_view name_of(Verdict verdict) {
  static constexpr std::array<std::string_view, verdict_count> names{
      "proved", "refuted", "given", "definition", "undecided", "not-understood", "skipped"};
  return names[static_cast<std::size_t>(verdict)];
}

bool shows_repairs(DiagnosticKind kind) {
  return kind == DiagnosticKind::refuted || kind == DiagnosticKind::free_index_mismatch ||
         kind == DiagnosticKind::index_repeats || kind == DiagnosticKind::index_clash ||
         kind == DiagnosticKind::rank_mismatch;
}

Tally tally(const Report& report, bool strict) {
  Tally total;
  const auto note = [&](const Diagnostics& diagnostics, bool refutation_is_expected) {
    for (const Diagnostic& diagnostic : diagnostics) {
      const Severity severity = diagnostic.severity();
      total.wrong = total.wrong || severity == Severity::error || (severity == Severity::warning && strict) ||
                    (severity == Severity::refuted && !refutation_is_expected);
      total.open = total.open || severity == Severity::undecided || severity == Severity::not_understood;
    }
  };
  for (const FileReport& file : report.files) {
    total.failed = total.failed || !file.failure.empty();
    total.unreadable = total.unreadable || file.unreadable;
    note(file.diagnostics, false);
    for (const Step& step : file.steps) {
      note(step.diagnostics, step.expected_refuted);
      total.wrong = total.wrong || (step.verdict == Verdict::refuted && !step.expected_refuted);
      total.open =
          total.open || step.verdict == Verdict::undecided || step.verdict == Verdict::not_understood;
    }
  }
  return total;
}

}  // namespace rigor
