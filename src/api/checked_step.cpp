// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/checked_step.h"

#include <ostream>

#include "report/text/terminal.h"
#include "report/wording/sample.h"

namespace rigor {
namespace {

/// Judged as a report of nothing but this.
Tally judged(const FileReport& part, bool strict) {
  Report report;
  report.files.push_back(part);
  return tally(report, strict);
}

/// Without its head and its line break: `\mathbf{A} = (1, 0, 0); left 0, right 2`.
std::string sample_text(const Counterexample& sample) {
  constexpr std::string_view head = "sample: ";
  std::string text = print_sample(sample);
  if (text.starts_with(head)) text.erase(0, head.size());
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string without_first_line_break(std::string text) {
  if (text.starts_with('\n')) text.erase(0, 1);
  return text;
}

}  // namespace

CheckedStep checked_step(const FileReport& file, const Step& step, const SourceMap& sources, bool strict) {
  FileReport part;
  part.path = file.path;
  part.file = file.file;
  part.steps.push_back(step);
  const Tally found = judged(part, strict);
  const LineColumn at = sources.line_column(step.span.file, step.span.begin);
  CheckedStep checked;
  checked.verdict = static_cast<StepVerdict>(step.verdict);
  checked.holds = !found.wrong && !found.open;
  checked.file = sources.path(step.span.file);
  checked.line = at.line;
  checked.column = at.column;
  checked.tag = step.tag;
  checked.statement = step.source;
  checked.route = step.route;
  checked.uses = step.uses;
  if (step.counterexample) checked.sample = sample_text(*step.counterexample);
  for (const Repair& repair : step.repairs) checked.repairs.push_back(repair.statement);
  checked.conditions = step.conditions;
  checked.message = without_first_line_break(print_diagnostics(part, sources));
  return checked;
}

RestOfNotes rest_of_notes(const FileReport& file, const SourceMap& sources, bool strict) {
  FileReport rest = file;
  rest.steps.clear();
  const Tally found = judged(rest, strict);
  return {found.wrong || found.unreadable || found.open,
          without_first_line_break(print_diagnostics(rest, sources))};
}

std::string_view name_of(StepVerdict verdict) { return name_of(static_cast<Verdict>(verdict)); }

std::ostream& operator<<(std::ostream& out, const CheckedStep& checked) {
  out << checked.statement << "\n" << name_of(checked.verdict);
  if (!checked.route.empty()) out << " (" << checked.route << ")";
  if (!checked.message.empty()) out << "\n" << checked.message;
  return out;
}

std::ostream& operator<<(std::ostream& out, const CheckedNotes& checked) {
  out << checked.file << ": " << checked.steps.size() << (checked.steps.size() == 1 ? " step" : " steps");
  if (!checked.message.empty()) out << "\n" << checked.message;
  return out;
}

}  // namespace rigor
