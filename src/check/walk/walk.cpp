// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/walk/walk.h"

#include <algorithm>
#include <span>
#include <utility>

#include "check/question/unread.h"
#include "check/row/row.h"
#include "check/scope/frame.h"
#include "check/scope/section_evidence.h"
#include "check/walk/state.h"
#include "check/walk/topics.h"

namespace rigor {
namespace {

/// An assumption, or with `:=` a symbol of its own, for the next statement.
void follow_where(Walk& walk, const Directive& directive, Context context) {
  for (const ParsedChain& parsed : directive.chains) {
    const bool defines = parsed.written.relations[0].kind == RelationKind::defines;
    context.role = defines ? Role::let : Role::given;
    if (defines) declare_for_now(walk, directive, parsed.sides[0]);
    follow_chain(walk, parsed, context);
    if (defines) walk.used.erase(directive.number);  // so far it was read by itself only
  }
}

bool take_first_order(Walk& walk) {
  const Directive* directive = std::exchange(walk.next.first_order, nullptr);
  if (directive != nullptr) walk.used.insert(directive->number);
  return directive != nullptr;
}

const WrittenChain* chain_of(const ParsedDisplay& display, const Step& step) {
  for (const ParsedChain& parsed : display.chains) {
    for (const WrittenRelation& relation : parsed.written.relations) {
      if (relation.span == step.relation_span) return &parsed.written;
    }
  }
  return nullptr;
}

/// It is not meant for all values.
bool may_be_condition(const Step& step) {
  return step.verdict == Verdict::law ||
         std::ranges::any_of(step.diagnostics, [](const Diagnostic& diagnostic) {
           return diagnostic.kind == DiagnosticKind::follows_from_nothing;
         });
}

/// `(A×B)² = A²B², A·B = 0`: a law next to an equation on its line may be the condition under which it holds.
/// Then what is refuted without it is not understood. So a line's verdicts are final when its display is
/// over.
void settle_lines(const ParsedDisplay& display, std::span<Step> steps) {
  for (const Step& law : steps) {
    const WrittenChain* condition = may_be_condition(law) ? chain_of(display, law) : nullptr;
    if (condition == nullptr) continue;
    for (Step& step : steps) {
      if (step.verdict != Verdict::refuted || step.expected_refuted) continue;
      const WrittenChain* own = chain_of(display, step);
      if (own == nullptr || condition == own || condition->statement != own->statement) continue;
      step.verdict = Verdict::not_understood;
      step.counterexample.reset();
      step.chain.reset();
      step.repairs.clear();
      step.conditions.clear();
      step.diagnostics = {{DiagnosticKind::unsupported,
                           step.relation_span,
                           "it does not hold for all values, and what is next to it may be its condition",
                           {{law.relation_span, "this condition is not read"}}}};
    }
  }
}

/// No row below defines the unknown of a problem, and no letter of it is a free constant of its solution.
void mark_seen(Walk& walk, const Equation& equation) {
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(walk.tree, side)) {
      mark_seen(walk.names.scope, symbol);
      mark_seen(walk.names.scope, base_of(walk.tree.symbols, symbol));
    }
  }
}

/// What the lines before this display say is there for its rows, and those below.
void take_what_lines_say(Walk& walk) {
  if (!decides(walk)) return;
  const std::vector<SaidInLine>& said = walk.notes.prose.said;
  for (; walk.lines_taken < said.size() && said[walk.lines_taken].before <= walk.event; ++walk.lines_taken) {
    RowPlace place = place_here(walk);
    leave_what_a_line_says(place, said[walk.lines_taken]);
    if (place.found.stated.empty()) continue;
    walk.names.symbols = std::move(place.names.symbols);  // its letters are those of the rows below
    for (const StatedLaw& stated : place.found.stated) {
      if (stated.poses) mark_seen(walk, stated.law.equation);
    }
    take_over(walk, std::move(place.found));
  }
}

void follow_chains(Walk& walk, const ParsedDisplay& display) {
  take_what_lines_say(walk);
  const Directive* skip = std::exchange(walk.next.skip, nullptr);
  if (skip != nullptr) walk.used.insert(skip->number);
  const bool no_relation = std::ranges::none_of(
      display.chains, [](const ParsedChain& parsed) { return !parsed.written.relations.empty(); });
  if (display.unread || display.chains.empty() || (skip != nullptr && no_relation)) {
    Step step;
    step.span = step.relation_span = display.span;
    step.section = walk.section;
    step.source = written_at(walk.sources, {display.span.file, display.span.begin,
                                            std::min(display.span.end, display.span.begin + 200)});
    step.verdict = skip != nullptr ? Verdict::skipped : Verdict::not_understood;
    step.diagnostics = display.diagnostics;
    if (skip != nullptr) step.route = skip->text;
    if (step.diagnostics.empty() && skip == nullptr) return;
    if (!display.tags.empty()) step.tag = display.tags.front();
    for (std::size_t k = 1; k < display.tags.size(); ++k) {
      add_step(walk, step);  // what there is to say is said once
      step.diagnostics.clear();
      step.tag = display.tags[k];
    }
    add_step(walk, std::move(step));
    return;
  }
  walk.report.diagnostics.insert(walk.report.diagnostics.end(), display.diagnostics.begin(),
                                 display.diagnostics.end());
  const std::size_t first_step = walk.report.steps.size();
  const Context context{.role = Role::display, .first_order = take_first_order(walk)};
  for (const ParsedChain& parsed : display.chains) {
    if (skip == nullptr) {
      follow_chain(walk, parsed, context);
      continue;
    }
    for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
      Step skipped = new_step(walk, parsed, k, {});
      skipped.verdict = Verdict::skipped;
      skipped.route = skip->text;
      add_step(walk, std::move(skipped));
    }
  }
  if (skip == nullptr) settle_lines(display, std::span(walk.report.steps).subspan(first_step));
}

void forget_wheres(Walk& walk) {
  if (!walk.next.wheres.empty()) walk.ledger.entries.push_back({scope_here(walk), StatementEnds{}});
  for (const std::size_t directive : std::exchange(walk.next.wheres, {})) forget(walk.names, directive);
}

/// What was said for one statement is forgotten, also where that was not read.
void end_statement(Walk& walk, Span span) {
  forget_wheres(walk);
  static_cast<void>(take_first_order(walk));
  for (const Directive* expectation : std::exchange(walk.next.expectations, {}))
    report_unmet(walk, *expectation, span);
}

void follow(Walk& walk, const ParsedDisplay& display) {
  follow_chains(walk, display);
  end_statement(walk, display.span);
}

void follow(Walk& walk, const PlacedDirective& placed) {
  const Directive& directive = placed.directive;
  Context context{.role = Role::claim, .place = placed.place, .directive = directive.number};
  const bool assumes = directive.kind == DirectiveKind::given || directive.kind == DirectiveKind::where;
  if (assumes && directive.chains.empty()) {
    note_unread(walk.names.scope, {directive.text, letters_of(directive.text), directive.number});
    walk.used.insert(directive.number);  // that it was not read is said
  }
  switch (directive.kind) {
    case DirectiveKind::expect:
      walk.next.expectations.push_back(&directive);
      return;
    case DirectiveKind::skip:
      walk.next.skip = &directive;
      return;
    case DirectiveKind::first_order:
      walk.next.first_order = &directive;
      return;
    case DirectiveKind::where:
      walk.next.wheres.push_back(directive.number);
      follow_where(walk, directive, context);
      return;
    case DirectiveKind::claim:
      walk.used.insert(directive.number);
      break;
    case DirectiveKind::given:
      context.role = Role::given;
      break;
    case DirectiveKind::let:
      context.role = Role::let;
      break;
    default:
      take_declaration(walk, directive);
      return;
  }
  if (directive.kind == DirectiveKind::claim) context.first_order = take_first_order(walk);
  for (const ParsedChain& parsed : directive.chains) follow_chain(walk, parsed, context);
  if (directive.kind == DirectiveKind::claim) end_statement(walk, placed.place);
}

void end_section(Walk& walk) {
  forget_wheres(walk);
  for (const auto& [directive, symbol] : walk.constants) {
    if (seen_in_equation(walk.names.scope, symbol)) walk.used.insert(directive);
  }
  for (const Directive* expectation : std::exchange(walk.next.expectations, {}))
    walk.ledger.unmatched.push_back(expectation);
  for (const Directive** pending : {&walk.next.skip, &walk.next.first_order}) {
    if (*pending != nullptr) walk.ledger.unmatched.push_back(std::exchange(*pending, nullptr));
  }
}

void follow(Walk& walk, const Heading& heading) {
  end_section(walk);
  leave_frames(walk.tree, walk.names, heading.level, walk.used);
  open_section(walk.names, heading.level);
  walk.names.symbols.evidence = Shared(evidence_of_section(walk.sources, walk.notes, walk.event));
  walk.ledger.entries.push_back({scope_here(walk), SectionBegins{}});
  walk.section = heading.title;
}

/// Steps are large, and there may be many.
std::size_t most_steps(const Notes& notes) {
  std::size_t count = 0;
  for (const Event& event : notes.events) {
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& parsed : display->chains) count += parsed.written.relations.size();
    if (display->unread) count += std::max<std::size_t>(display->tags.size(), 1);
  }
  return count;
}

Ledger to_the_end(Walk& walk) {
  walk.report.steps.reserve(most_steps(walk.notes));
  for (std::size_t k = 0; k < walk.notes.events.size(); ++k) {
    walk.event = k;
    std::visit([&](const auto& event) { follow(walk, event); }, walk.notes.events[k]);
    if (walk.request.explains) walk.ledger.behind_events.push_back(scope_here(walk));
    if (walk.options.progress) walk.options.progress(k + 1, walk.notes.events.size());
  }
  end_section(walk);
  walk.ledger.end = scope_here(walk);
  walk.ledger.used = std::move(walk.used);
  for (const Step& step : walk.report.steps) ++walk.report.counts[static_cast<std::size_t>(step.verdict)];
  return std::move(walk.ledger);
}

}  // namespace

Ledger walk_through(const SourceMap& sources, const Notes& notes, FileReport& report,
                    const CheckOptions& options, WalkRequest request) {
  Walk walk{sources, notes, report, options, std::move(request)};
  walk.names = names_at_beginning(sources, notes, walk.tree);
  return to_the_end(walk);
}

}  // namespace rigor
