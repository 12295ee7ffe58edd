// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/walk/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/among.h"
#include "check/event/sidecar_places.h"
#include "check/lint/lint_scopes.h"
#include "check/question/unread.h"
#include "check/scope/frame.h"
#include "check/scope/local_kinds.h"
#include "check/scope/section_evidence.h"

namespace rigor {

Session::Session(const SourceMap& sources, const Notes& notes, FileReport& report,
                 const CheckOptions& options)
    : sources_(sources), notes_(notes), report_(report), options_(options) {}

void Session::run() {
  sight_all();
  names_.evidence = evidence_of_section(sources_, notes_, std::nullopt);
  if (options_.forms != nullptr) options_.forms->plan(names_);
  for (std::size_t k = 0; k < notes_.events.size(); ++k) {
    if (options_.forms != nullptr) options_.forms->enter(k);
    event_ = k;
    std::visit([this](const auto& event) { follow(event); }, notes_.events[k]);
    if (std::holds_alternative<Heading>(notes_.events[k]))
      names_.evidence = evidence_of_section(sources_, notes_, k);
    if (options_.forms != nullptr) options_.forms->ask(k, tree_, names_);
    if (options_.progress) options_.progress(k + 1, notes_.events.size());
  }
  if (options_.forms != nullptr && notes_.events.empty()) options_.forms->ask(0, tree_, names_);
  if (options_.forms != nullptr) options_.forms->see(tree_, names_);
  if (!decides()) return;
  finish_dimensions();
  report_lints();
  label_places(notes_, report_);
  report_unused();
}

/// What is silenced is kept apart; whatever silences something, and whatever asks for a warning, is used.
void Session::report_lints() {
  const LintScopes scopes(notes_);
  lint({sources_, notes_, tree_, stated_, report_, mirrored_}, scopes, report_);
  for (const std::size_t directive : silence(scopes, report_)) names_.mark_used(directive);
  for (const Directive* directive : directives_) {
    if (directive->kind == DirectiveKind::warn) names_.mark_used(directive->number);
  }
}

/// How symbols are written anywhere in the file decides what their letters mean everywhere.
void Session::sight_all() {
  sight_events(notes_, names_, [](std::size_t) { return true; });
  imply_primed_axes();
}

void Session::follow(const Heading& heading) {
  end_section();
  leave_frames(tree_, names_, heading.level);
  names_.open_section(tree_.symbols, heading.level);
  dimensions_.enter_section();
  section_ = heading.title;
}

void Session::follow(const PlacedDirective& placed) {
  const Directive& directive = placed.directive;
  directives_.push_back(&directive);
  Context context{.role = Role::claim, .place = placed.place, .directive = directive.number};
  const bool assumes = directive.kind == DirectiveKind::given || directive.kind == DirectiveKind::where;
  if (assumes && directive.chains.empty()) {
    names_.note_unread({directive.text, letters_of(directive.text), directive.number});
    names_.mark_used(directive.number);  // that it was not read is said
  }
  switch (directive.kind) {
    case DirectiveKind::expect:
      expectations_.push_back(&directive);
      return;
    case DirectiveKind::skip:
      skip_ = &directive;
      return;
    case DirectiveKind::first_order:
      first_order_ = &directive;
      return;
    case DirectiveKind::where:
      wheres_.push_back(directive.number);
      follow_where(directive, context);
      return;
    case DirectiveKind::claim:
      names_.mark_used(directive.number);
      break;
    case DirectiveKind::given:
      context.role = Role::given;
      break;
    case DirectiveKind::let:
      context.role = Role::let;
      break;
    default:
      declare(directive);
      return;
  }
  if (directive.kind == DirectiveKind::claim) context.first_order = take_first_order();
  for (const ParsedChain& parsed : directive.chains) chain(parsed, context);
  if (directive.kind == DirectiveKind::claim) end_statement(placed.place);
}

/// An assumption, or with `:=` a symbol of its own, for the next statement.
void Session::follow_where(const Directive& directive, Context context) {
  for (const ParsedChain& parsed : directive.chains) {
    const bool defines = parsed.written.relations[0].kind == RelationKind::defines;
    context.role = defines ? Role::let : Role::given;
    if (defines) declare_for_now(directive, parsed.sides[0]);
    chain(parsed, context);
    if (defines) names_.mark_unused(directive.number);  // so far it was read by itself only
  }
}

void Session::follow(const ParsedDisplay& display) {
  follow_chains(display);
  end_statement(display.span);
}

void Session::follow_chains(const ParsedDisplay& display) {
  const Directive* skip = std::exchange(skip_, nullptr);
  if (skip != nullptr) names_.mark_used(skip->number);
  const bool no_relation =
      std::none_of(display.chains.begin(), display.chains.end(),
                   [](const ParsedChain& parsed) { return !parsed.written.relations.empty(); });
  if (display.unread || display.chains.empty() || (skip != nullptr && no_relation)) {
    Step step;
    step.span = step.relation_span = display.span;
    step.section = section_;
    step.source = written(
        {display.span.file, display.span.begin, std::min(display.span.end, display.span.begin + 200)});
    step.verdict = skip != nullptr ? Verdict::skipped : Verdict::not_understood;
    step.diagnostics = display.diagnostics;
    if (skip != nullptr) step.route = skip->text;
    if (step.diagnostics.empty() && skip == nullptr) return;
    if (!display.tags.empty()) step.tag = display.tags.front();
    for (std::size_t k = 1; k < display.tags.size(); ++k) {
      add(step);  // what there is to say is said once
      step.diagnostics.clear();
      step.tag = display.tags[k];
    }
    add(std::move(step));
    return;
  }
  report_.diagnostics.insert(report_.diagnostics.end(), display.diagnostics.begin(),
                             display.diagnostics.end());
  const std::size_t first_step = report_.steps.size();
  const Context context{.role = Role::display, .first_order = take_first_order()};
  for (const ParsedChain& parsed : display.chains) {
    if (skip == nullptr) {
      chain(parsed, context);
      continue;
    }
    for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
      Step skipped = new_step(parsed, k, {});
      skipped.verdict = Verdict::skipped;
      skipped.route = skip->text;
      add(std::move(skipped));
    }
  }
  if (skip == nullptr) heed_conditions(display, first_step);
}

bool Session::take_first_order() {
  const Directive* directive = std::exchange(first_order_, nullptr);
  if (directive != nullptr) names_.mark_used(directive->number);
  return directive != nullptr;
}

/// What was said for one statement is forgotten, also where that was not read.
void Session::end_statement(Span span) {
  forget_wheres();
  static_cast<void>(take_first_order());
  for (const Directive* expectation : std::exchange(expectations_, {})) report_unmet(*expectation, span);
}

void Session::end_section() {
  forget_wheres();
  for (const Directive* expectation : std::exchange(expectations_, {})) unmatched_.push_back(expectation);
  for (const Directive** pending : {&skip_, &first_order_}) {
    if (*pending != nullptr) unmatched_.push_back(std::exchange(*pending, nullptr));
  }
}

void Session::forget_wheres() {
  dimensions_.forget_assumed();
  for (const std::size_t directive : std::exchange(wheres_, {})) names_.forget(directive);
}

/// Is this said by a `where`?
bool Session::is_for_now(const Context& context) const {
  const bool directed = context.role == Role::let || context.role == Role::given;
  return directed && is_one_of(context.directive, wheres_);
}

/// `(A×B)² = A²B², A·B = 0`: a law beside an equation on its line may be the condition under which it holds.
/// Then what was refuted without it is not understood.
void Session::heed_conditions(const ParsedDisplay& display, std::size_t first_step) {
  const auto chain_of = [&](const Step& step) -> const WrittenChain* {
    for (const ParsedChain& parsed : display.chains) {
      for (const WrittenRelation& relation : parsed.written.relations) {
        if (relation.span == step.relation_span) return &parsed.written;
      }
    }
    return nullptr;
  };
  for (std::size_t law = first_step; law < report_.steps.size(); ++law) {
    const Diagnostics& reasons = report_.steps[law].diagnostics;
    const bool is_law = std::any_of(reasons.begin(), reasons.end(), [](const Diagnostic& reason) {
      return reason.kind == DiagnosticKind::undeclared_symbol;
    });
    if (!is_law) continue;
    for (std::size_t k = first_step; k < report_.steps.size(); ++k) {
      Step& step = report_.steps[k];
      if (step.verdict != Verdict::refuted || step.expected_refuted) continue;
      const WrittenChain* condition = chain_of(report_.steps[law]);
      const WrittenChain* own = chain_of(step);
      const bool beside = condition != nullptr && own != nullptr && condition != own &&
                          condition->statement == own->statement;
      if (!beside) continue;
      --report_.counts[static_cast<std::size_t>(step.verdict)];
      step.verdict = Verdict::not_understood;
      ++report_.counts[static_cast<std::size_t>(step.verdict)];
      step.counterexample.reset();
      step.chain.reset();
      step.repairs.clear();
      step.conditions.clear();
      step.diagnostics = {{DiagnosticKind::unsupported,
                           step.relation_span,
                           "it does not hold for all values, and what stands beside it may be its condition",
                           {{report_.steps[law].relation_span, "this condition is not read"}}}};
    }
  }
}

void Session::report_unused() {
  for (const auto& [directive, symbol] : constants_) {
    if (names_.seen_in_equation(symbol)) names_.mark_used(directive);
  }
  end_section();
  for (const Directive* directive : directives_) {
    const bool pending = is_one_of(directive, unmatched_);
    const bool standing = directive->kind != DirectiveKind::expect &&
                          directive->kind != DirectiveKind::skip &&
                          directive->kind != DirectiveKind::first_order;
    if (standing ? names_.is_used(directive->number) : !pending) continue;
    // what it is about may stand in a step that is not read
    const bool unread = report_.counts[static_cast<std::size_t>(Verdict::not_understood)] > 0;
    if (directive->kind == DirectiveKind::units && unread) continue;
    report_.diagnostics.push_back({DiagnosticKind::unused_directive,
                                   directive->span,
                                   fmt::format("nothing uses `{}`", directive->text),
                                   {},
                                   {"take the line away, or move it before what it is for"}});
  }
}

}  // namespace rigor
