// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/review/review.h"

#include <fmt/format.h>

#include "base/among.h"
#include "check/dimension/dimensions.h"
#include "check/event/sidecar_places.h"
#include "check/lint/lint.h"
#include "check/lint/lint_scopes.h"

namespace rigor {
namespace {

/// All relations whose sides were read, cyclic images apart.
std::vector<StatedEquation> stated_equations(const Ledger& ledger) {
  std::vector<StatedEquation> stated;
  for (const LedgerEntry& entry : ledger.entries) {
    const auto* statement = std::get_if<Statement>(&entry.what);
    if (statement == nullptr || statement->chain->image > 0) continue;
    for (std::size_t k = 0; k < statement->step_count; ++k) {
      const auto& left = statement->sides[k];
      const auto& right = statement->sides[k + 1];
      const WrittenRelation& relation = statement->chain->written.relations[k];
      if (left && right)
        stated.push_back({left->id, right->id, relation.span, relation.kind, is_claimed(statement->role),
                          statement->for_now, statement->first_step + k});
    }
  }
  return stated;
}

/// The directives that a declared unit or a silenced warning uses.
Directives compare_dimensions(const Ledger& ledger, const Notes& notes, const SourceMap& sources,
                              FileReport& report) {
  const DimensionRecord record = record_dimensions(ledger, notes.syntax, report);
  solve_dimensions(record, sources, report);
  Directives used;
  for (const DeclaredUnit& unit : record.units) {
    if (unit.used) used.insert(unit.directive);
  }
  return used;
}

/// It is used by the next statement alone, unless none comes before the end of its section.
bool waits_for_a_statement(DirectiveKind kind) {
  return kind == DirectiveKind::expect || kind == DirectiveKind::skip || kind == DirectiveKind::first_order;
}

void report_unused(const Ledger& ledger, const Notes& notes, const Directives& used, FileReport& report) {
  const bool some_unread = report.counts[static_cast<std::size_t>(Verdict::not_understood)] > 0;
  for (const Event& event : notes.events) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed == nullptr) continue;
    const Directive& directive = placed->directive;
    const bool is_used = waits_for_a_statement(directive.kind)
                             ? !is_one_of(&directive, ledger.unmatched)
                             : used.contains(directive.number) || ledger.used.contains(directive.number);
    // what it is about may be in a step that is not read
    if (is_used || (directive.kind == DirectiveKind::units && some_unread)) continue;
    report.diagnostics.push_back({DiagnosticKind::unused_directive,
                                  directive.span,
                                  fmt::format("nothing uses `{}`", directive.text),
                                  {},
                                  {"remove the line, or move it above what it is for"}});
  }
}

}  // namespace

void review(const Ledger& ledger, const Notes& notes, const SourceMap& sources, FileReport& report) {
  Directives used = compare_dimensions(ledger, notes, sources, report);
  const LintScopes scopes(notes);
  lint({sources, notes, ledger.tree, stated_equations(ledger), report, ledger.mirrored}, scopes, report);
  used.merge(silence(scopes, report));
  for (const Event& event : notes.events) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed != nullptr && placed->directive.kind == DirectiveKind::warn)
      used.insert(placed->directive.number);
  }
  label_places(notes, report);
  report_unused(ledger, notes, used, report);
}

}  // namespace rigor
