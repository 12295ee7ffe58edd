// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/step/failure_rule.h"

namespace rigor {

FailureRule usual_rule(bool strict) {
  FailureRule rule;
  if (strict) rule.wrong.insert({Severity::warning, Severity::suspect});
  return rule;
}

std::optional<Severity> severity_of(const Step& step) {
  switch (step.verdict) {
    case Verdict::refuted:
      return step.expected_refuted ? std::nullopt : std::optional(Severity::refuted);
    case Verdict::undecided:
      return Severity::undecided;
    case Verdict::not_understood:
      return Severity::not_understood;
    case Verdict::suspect:
      return step.expected_refuted ? std::nullopt : std::optional(Severity::suspect);
    case Verdict::proved:
    case Verdict::given:
    case Verdict::definition:
    case Verdict::skipped:
    case Verdict::law:
      return std::nullopt;
  }
  return std::nullopt;
}

bool is_expected(const Diagnostic& diagnostic, const Step* step) {
  const Severity severity = diagnostic.severity();
  return (severity == Severity::refuted || severity == Severity::suspect) && step != nullptr &&
         step->expected_refuted;
}

Tally tally(const Report& report, const FailureRule& rule) {
  Tally total;
  const auto count = [&](Severity severity) {
    total.wrong = total.wrong || rule.wrong.contains(severity);
    total.open = total.open || rule.open.contains(severity);
  };
  const auto note = [&](const Diagnostics& diagnostics, const Step* step) {
    for (const Diagnostic& diagnostic : diagnostics) {
      if (!is_expected(diagnostic, step) && !rule.known.has(diagnostic)) count(diagnostic.severity());
    }
  };
  for (const FileReport& file : report.files) {
    total.failed = total.failed || !file.failure.empty();
    total.unreadable = total.unreadable || file.unreadable;
    note(file.diagnostics, nullptr);
    for (const Step& step : file.steps) {
      note(step.diagnostics, &step);
      const auto severity = severity_of(step);
      if (severity && !rule.known.has(step)) count(*severity);
    }
  }
  return total;
}

}  // namespace rigor
