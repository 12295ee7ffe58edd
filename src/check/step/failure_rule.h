// SPDX-License-Identifier: GPL-3.0-or-later
// Which findings make a run wrong, and which leave it open: one rule for the exit code and for every format.
#pragma once

#include <optional>
#include <set>

#include "check/step/report.h"

namespace rigor {

/// Findings of one report that an earlier report has, too. The report must not move or change.
struct KnownFindings {
  std::set<const Diagnostic*> diagnostics = {};
  std::set<const Step*> steps = {};  // whose verdict is known

  [[nodiscard]] bool has(const Diagnostic& diagnostic) const { return diagnostics.contains(&diagnostic); }
  [[nodiscard]] bool has(const Step& step) const { return steps.contains(&step); }
};

/// What is neither wrong nor open is passed over, and so is what is known.
struct FailureRule {
  std::set<Severity> wrong = {Severity::error, Severity::refuted};
  std::set<Severity> open = {Severity::undecided, Severity::not_understood, Severity::suspect};
  KnownFindings known = {};
};

/// `strict`: warnings and suspects are wrong.
[[nodiscard]] FailureRule usual_rule(bool strict);

/// How bad a step's verdict is by itself; nothing: it is as it should be, or as a directive expects.
[[nodiscard]] std::optional<Severity> severity_of(const Step& step);
/// A refutation or a suspicion that a directive expects is no finding.
[[nodiscard]] bool is_expected(const Diagnostic& diagnostic, const Step* step);

[[nodiscard]] Tally tally(const Report& report, const FailureRule& rule);

}  // namespace rigor
