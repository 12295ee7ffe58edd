// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/step/report.h"

#include <fmt/format.h>

#include "check/step/failure_rule.h"

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
  return kind == DiagnosticKind::refuted || kind == DiagnosticKind::suspect ||
         kind == DiagnosticKind::free_index_mismatch || kind == DiagnosticKind::index_repeats ||
         kind == DiagnosticKind::index_clash || kind == DiagnosticKind::rank_mismatch;
}

Tally tally(const Report& report, bool strict) { return tally(report, usual_rule(strict)); }

}  // namespace rigor
