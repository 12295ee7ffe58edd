// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/lint/lint_scopes.h"

#include <algorithm>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

bool is_statement(const Event& event) {
  if (std::holds_alternative<ParsedDisplay>(event)) return true;
  const auto* placed = std::get_if<PlacedDirective>(&event);
  return placed != nullptr && placed->directive.kind == DirectiveKind::claim;
}

}  // namespace

/// One pass: what is open ends with the section or the statement that it is open for.
LintScopes::LintScopes(const Notes& notes) {
  int level = 0;
  std::vector<std::pair<std::size_t, int>> to_section;  // scopes, with the level of their section: it grows
  std::vector<std::size_t> to_statement;
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    const Event& event = notes.events[k];
    const auto* placed = std::get_if<PlacedDirective>(&event);
    places_.push_back({placed != nullptr ? placed->directive.span : span_of(event), k, placed != nullptr});
    if (placed != nullptr && !placed->directive.warnings.empty()) {
      const bool here = placed->directive.here;
      if (here)
        to_statement.push_back(scopes_.size());
      else
        to_section.emplace_back(scopes_.size(), level);
      scopes_.push_back({&placed->directive, k, here ? k : notes.events.size()});
    }
    if (const auto* heading = std::get_if<Heading>(&event)) {
      level = heading->level;
      to_statement.clear();
      for (; !to_section.empty() && level <= to_section.back().second; to_section.pop_back())
        scopes_[to_section.back().first].end = k;
    }
    if (!is_statement(event)) continue;
    for (const std::size_t scope : to_statement) scopes_[scope].end = k + 1;
    to_statement.clear();
  }
  std::ranges::sort(places_, {}, &Place::key);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    Place& place = places_[k];
    const Place* before = k > 0 && places_[k - 1].span.file == place.span.file ? &places_[k - 1] : nullptr;
    place.ground = place.is_line ? (before != nullptr ? before->ground : no_place) : k;
    place.lines_end = before != nullptr ? before->lines_end : 0;
    if (place.is_line) place.lines_end = std::max(place.lines_end, place.span.end);
  }
}

/// The last event that begins at or before the place, in the same file. A directive's line reaches to its end
/// only, and lines follow each other: hardly more than one is looked at.
std::optional<std::size_t> LintScopes::event_at(Span place) const {
  const std::tuple key{place.file, place.begin, places_.size()};
  for (auto at = static_cast<std::size_t>(std::ranges::upper_bound(places_, key, {}, &Place::key) -
                                          places_.begin());
       at-- > 0 && places_[at].span.file == place.file;) {
    const Place& each = places_[at];
    if (!each.is_line || place.begin < each.span.end) return each.event;
    if (place.begin < each.lines_end) continue;
    if (each.ground == no_place) return std::nullopt;
    return places_[each.ground].event;
  }
  return std::nullopt;
}

const Directive* LintScopes::said_of(DiagnosticKind kind, Span place) const {
  if (scopes_.empty()) return nullptr;
  const auto event = event_at(place);
  if (!event) return nullptr;
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const std::vector<DiagnosticKind>& kinds = scope->directive->warnings;
    const bool covers = scope->begin <= *event && *event < scope->end;
    if (covers && is_one_of(kind, kinds)) return scope->directive;
  }
  return nullptr;
}

bool LintScopes::asks_for(DiagnosticKind kind, Span place) const {
  const Directive* directive = said_of(kind, place);
  return directive != nullptr && directive->kind == DirectiveKind::warn;
}

bool LintScopes::asks_somewhere(DiagnosticKind kind) const {
  return std::ranges::any_of(scopes_, [&](const Scope& scope) {
    const std::vector<DiagnosticKind>& kinds = scope.directive->warnings;
    return scope.directive->kind == DirectiveKind::warn && is_one_of(kind, kinds);
  });
}

std::set<std::size_t> silence(const LintScopes& scopes, FileReport& report) {
  std::set<std::size_t> used;
  const auto sift = [&](Diagnostics& diagnostics) {
    Diagnostics kept;
    for (Diagnostic& diagnostic : diagnostics) {
      const Directive* directive = diagnostic.severity() == Severity::warning
                                       ? scopes.said_of(diagnostic.kind, diagnostic.span)
                                       : nullptr;
      const bool silent = directive != nullptr && directive->kind == DirectiveKind::allow;
      if (silent) used.insert(directive->number);
      (silent ? report.silenced : kept).push_back(std::move(diagnostic));
    }
    diagnostics = std::move(kept);
  };
  for (Step& step : report.steps) sift(step.diagnostics);
  sift(report.diagnostics);
  return used;
}

}  // namespace rigor
