// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/lint/lint_scopes.h"

#include <algorithm>

#include "base/among.h"

namespace rigor {
namespace {

bool is_statement(const Event& event) {
  if (std::holds_alternative<ParsedDisplay>(event)) return true;
  const auto* placed = std::get_if<PlacedDirective>(&event);
  return placed != nullptr && placed->directive.kind == DirectiveKind::claim;
}

/// The event after the section in which `from` stands.
std::size_t end_of_section(const std::vector<Event>& events, std::size_t from) {
  int level = 0;
  for (std::size_t k = 0; k < from; ++k) {
    if (const auto* heading = std::get_if<Heading>(&events[k])) level = heading->level;
  }
  std::size_t end = from;
  for (; end < events.size(); ++end) {
    const auto* heading = std::get_if<Heading>(&events[end]);
    if (heading != nullptr && heading->level <= level) break;
  }
  return end;
}

std::size_t end_of_statement(const std::vector<Event>& events, std::size_t from) {
  for (std::size_t k = from; k < events.size() && !std::holds_alternative<Heading>(events[k]); ++k) {
    if (is_statement(events[k])) return k + 1;
  }
  return from;
}

}  // namespace

LintScopes::LintScopes(const Notes& notes) {
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    const auto* placed = std::get_if<PlacedDirective>(&notes.events[k]);
    places_.push_back(
        {placed != nullptr ? placed->directive.span : span_of(notes.events[k]), k, placed != nullptr});
    if (placed == nullptr || placed->directive.warnings.empty()) continue;
    scopes_.push_back(
        {&placed->directive, k,
         placed->directive.here ? end_of_statement(notes.events, k) : end_of_section(notes.events, k)});
  }
}

/// The last event that begins at or before the place, in the same file.
std::optional<std::size_t> LintScopes::event_at(Span place) const {
  const Place* last = nullptr;
  for (const Place& each : places_) {
    if (each.span.file != place.file || each.span.begin > place.begin) continue;
    const bool nearer = last == nullptr || each.span.begin >= last->span.begin;
    if (nearer && (!each.is_line || place.begin < each.span.end)) last = &each;
  }
  return last == nullptr ? std::nullopt : std::optional(last->event);
}

const Directive* LintScopes::said_of(DiagnosticKind kind, Span place) const {
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
