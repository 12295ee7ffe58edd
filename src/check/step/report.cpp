// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/step/report.h"

#include <fmt/format.h>

namespace rigor {

std::string_view name_of(Verdict verdict) {
  static constexpr std::array<std::string_view, verdict_count> names{
      "proved", "refuted", "given", "definition", "undecided", "not-understood", "skipped", "law", "suspect"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string name_of_law(const std::string& tag, Span relation, const SourceMap& sources,
                        std::string_view word) {
  if (tag.empty())
    return fmt::format("{} in line {}", word, sources.line_column(relation.file, relation.begin).line);
  return fmt::format("{} {}", word, tag.starts_with('(') ? tag : fmt::format("({})", tag));
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
      total.open = total.open || severity == Severity::undecided || severity == Severity::not_understood ||
                   severity == Severity::suspect;
    }
  };
  for (const FileReport& file : report.files) {
    total.failed = total.failed || !file.failure.empty();
    total.unreadable = total.unreadable || file.unreadable;
    note(file.diagnostics, false);
    for (const Step& step : file.steps) {
      note(step.diagnostics, step.expected_refuted);
      total.wrong = total.wrong || (step.verdict == Verdict::refuted && !step.expected_refuted);
      total.open = total.open || step.verdict == Verdict::undecided ||
                   step.verdict == Verdict::not_understood || step.verdict == Verdict::suspect;
    }
  }
  return total;
}

}  // namespace rigor
