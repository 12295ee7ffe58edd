// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/utf8.h"
#include "report/wording/sample.h"

namespace rigor {
namespace {

/// Repairs are said once of a step, with its first diagnostic that they mend.
bool takes_repairs(const PlacedDiagnostic& placed) {
  if (placed.step == nullptr) return false;
  const Diagnostics& all = placed.step->diagnostics;
  const auto first =
      std::ranges::find_if(all, [](const Diagnostic& each) { return shows_repairs(each.kind); });
  return first != all.end() && &*first == placed.diagnostic;
}

}  // namespace

Weight weight_of(const PlacedDiagnostic& placed, const FailureRule& rule) {
  const Severity severity = placed.diagnostic->severity();
  if (is_expected(*placed.diagnostic, placed.step)) return Weight::expected;
  if (rule.known.has(*placed.diagnostic)) return Weight::known;
  if (rule.wrong.contains(severity)) return Weight::wrong;
  return rule.open.contains(severity) ? Weight::open : Weight::warning;
}

std::string place_text(Span span, const SourceMap& sources) {
  const LineColumn place = sources.line_column(span.file, span.begin);
  return fmt::format("{}:{}:{}", printable(sources.path(span.file)), place.line, place.column);
}

std::string details_of(const PlacedDiagnostic& placed, const SourceMap& sources) {
  std::string text;
  for (const Label& label : placed.diagnostic->labels) {
    if (!label.text.empty())
      text += fmt::format("{}: note: {}\n", place_text(label.span, sources), printable(label.text));
  }
  for (const std::string& help : placed.diagnostic->help) text += fmt::format("help: {}\n", printable(help));
  if (placed.step == nullptr) return text;
  if (placed.diagnostic->kind == DiagnosticKind::refuted && placed.step->counterexample)
    text += print_sample(*placed.step->counterexample);
  if (!takes_repairs(placed)) return text;
  for (const Repair& repair : placed.step->repairs)
    text += fmt::format("true is: {} ({})\n", printable(repair.statement), printable(repair.change));
  for (const std::string& condition : placed.step->conditions)
    text += fmt::format("holds if: {}\n", printable(condition));
  return text;
}

std::string_view heading_of_repairs(const Step& step) {
  const bool wrong =
      step.verdict == Verdict::refuted || step.verdict == Verdict::suspect ||
      std::ranges::any_of(step.diagnostics, [](const Diagnostic& each) { return shows_repairs(each.kind); });
  return wrong ? "true is" : "near it";
}

std::string remark_on(const Repair& repair) {
  if (repair.uses.empty()) return repair.change;
  return fmt::format("{}; it follows from {}", repair.change, fmt::join(repair.uses, ", "));
}

std::string path_from(const std::string& path, const std::string& folder) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  if (!normal.is_absolute()) return normal.generic_string();
  const std::filesystem::path relative = normal.lexically_relative(folder);
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return inside ? relative.generic_string() : normal.generic_string();
}

}  // namespace rigor
