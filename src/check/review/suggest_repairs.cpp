// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>

#include "check/question/decision_cache.h"
#include "check/repair/missing_condition.h"
#include "check/repair/repair.h"
#include "check/repair/sides_near.h"
#include "check/review/review.h"

namespace rigor {
namespace {

using Clock = std::chrono::steady_clock;

/// Not understood, since indices or ranks do not fit, and the page says of nothing near it that it follows.
bool is_malformed(const Step& step) {
  return step.verdict == Verdict::not_understood && step.repairs.empty() &&
         std::ranges::any_of(step.diagnostics, [](const Diagnostic& diagnostic) {
           return diagnostic.severity() == Severity::error && shows_repairs(diagnostic.kind);
         });
}

/// A side that another step supports is less likely to hold the slip.
Trust trust_by(const Statement& statement, std::size_t which, bool exists, const FileReport& report) {
  if (!exists) return Trust::unknown;
  const Verdict verdict = report.steps[statement.first_step + which].verdict;
  if (verdict == Verdict::proved) return Trust::supported;
  return verdict == Verdict::refuted ? Trust::doubted : Trust::unknown;
}

bool is_wrong(const Statement& statement, std::size_t which, const CheckOptions& options, const Step& step) {
  if (step.verdict != Verdict::refuted && !is_malformed(step)) return false;
  const auto& remainders = statement.chain->remainders;
  if (which + 1 < remainders.size() && remainders[which + 1]) return false;
  return !step.expected_refuted || options.repairs != Repairs::of_unexpected;
}

void suggest_repair(const LedgerEntry& entry, const Statement& statement, std::size_t which,
                    const Ledger& ledger, const Notes& notes, const CheckOptions& options,
                    FileReport& report) {
  const auto start = Clock::now();
  Step& step = report.steps[statement.first_step + which];
  const WrongStep wrong{.parsed = *statement.chain,
                        .which = which,
                        .first_order = statement.first_order,
                        .left = trust_by(statement, which - 1, which > 0, report),
                        .right = trust_by(statement, which + 1, which + 1 < statement.step_count, report),
                        .rules = statement.rules,
                        .near = sides_near(notes, *statement.chain)};
  options.cache->begin(options.effort);
  step.repairs = nearest_true_statements(ledger.tree, *entry.scope, wrong, options.cache);
  step.repair_milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (step.verdict == Verdict::refuted)
    step.conditions = missing_conditions(ledger.tree, *entry.scope, wrong, options.cache);
  step.work = std::max(step.work, options.cache->budget().used());
}

}  // namespace

void suggest_repairs(const Ledger& ledger, const Notes& notes, const CheckOptions& options,
                     FileReport& report) {
  if (options.repairs == Repairs::none) return;
  for (const LedgerEntry& entry : ledger.entries) {
    const auto* statement = std::get_if<Statement>(&entry.what);
    if (statement == nullptr || !is_claimed(statement->role) || statement->chain->image > 0) continue;
    for (std::size_t which = 0; which < statement->step_count; ++which) {
      if (is_wrong(*statement, which, options, report.steps[statement->first_step + which]))
        suggest_repair(entry, *statement, which, ledger, notes, options, report);
    }
  }
}

}  // namespace rigor
