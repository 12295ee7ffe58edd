// SPDX-License-Identifier: GPL-3.0-or-later
// A chain: how its sides are read, and its steps one after the other.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "check/doubt/row_doubts.h"
#include "check/question/decision_cache.h"
#include "check/repair/missing_condition.h"
#include "check/repair/repair.h"
#include "check/scope/local_kinds.h"
#include "check/walk/session.h"

namespace rigor {
namespace {

using Clock = std::chrono::steady_clock;

/// Not understood, since indices or ranks do not fit.
bool is_malformed(const Step& step) {
  return step.verdict == Verdict::not_understood &&
         std::any_of(step.diagnostics.begin(), step.diagnostics.end(), [](const Diagnostic& diagnostic) {
           return shows_repairs(diagnostic.kind) && diagnostic.kind != DiagnosticKind::refuted;
         });
}

/// Are all sides read, and does each step's pair of sides fit?
bool fits(const ParsedChain& parsed, ChainReading& reading) {
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
    Diagnostics mismatches;
    if (!reading.sides[k].typed || !reading.sides[k + 1].typed) return false;
    if (!reading.claim(parsed, k, false, mismatches)) return false;
  }
  return true;
}

}  // namespace

void Session::chain(const ParsedChain& parsed, const Context& context) {
  if (options_.forms != nullptr && !options_.forms->follows(parsed)) return;
  if (parsed.others.empty()) {
    chain_as_read(parsed, context);
  } else {
    chain_as_read(sensible_readings(parsed), context);
  }
}

void Session::chain_as_read(const ParsedChain& parsed, const Context& context) {
  const std::size_t first_step = report_.steps.size();
  if (parsed.written.relations.empty() && !reads(parsed)) return;
  if (parsed.written.relations.empty()) {
    report_.diagnostics.push_back({DiagnosticKind::no_relation, parsed.written.span,
                                   "no relation stands here, so there is nothing to decide"});
    return;
  }
  std::unique_ptr<ChainReading> reading = read_chain(notes_.syntax, tree_, names_, parsed);
  std::optional<LocalKinds> local;  // where only kinds of another section make it wrong
  if (context.role == Role::display && !fits(parsed, *reading)) {
    local.emplace(notes_, names_, event_);
    auto own = local->borrowed_letter(notes_.syntax, parsed)
                   ? read_chain(notes_.syntax, tree_, names_, parsed)
                   : nullptr;
    if (own && fits(parsed, *own)) {
      reading = std::move(own);
    } else {
      local.reset();
    }
  }
  reading->for_all =
      context.role == Role::claim || !expectations_.empty() || (parsed.image > 0 && !in_force_.empty());
  for (const std::string& letter : reading->how().unsummed) {
    reading->sides[0].diagnostics.push_back(
        {DiagnosticKind::unsummed_index,
         parsed.written.span,
         fmt::format(
             "index `{}` stands twice in a term and is read as not summed, since it is free elsewhere",
             letter),
         {},
         {"say `(\\text{no sum})` beside the equation"}});
  }
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) step(parsed, k, *reading, context);
  const bool directed = context.role == Role::given || context.role == Role::let;
  if (options_.recorded == nullptr && decides()) explain_slips(parsed, first_step, *reading, context);
  const std::vector<Side>& sides = reading->sides;
  const bool unsettled = !parsed.others.empty();
  if (!unsettled) mark_seen(sides);
  if (!unsettled) record_dimensions(parsed, *reading, context, first_step);
  if (context.role == Role::display || context.role == Role::claim) {
    excuse_refuted(parsed, first_step);
    suggest_repairs(parsed, context, first_step);
  }
  if (options_.forms != nullptr && !unsettled)
    options_.forms->add(
        tree_, names_,
        {parsed, *reading, std::span(report_.steps).subspan(first_step), directed, context.first_order});
}

/// What stands in the lines before and behind a chain.
std::vector<TokenView> Session::sides_near(const ParsedChain& parsed) const {
  constexpr std::size_t before = 6;
  constexpr std::size_t behind = 2;
  std::vector<const ParsedChain*> chains;
  std::size_t own = 0;
  const auto take = [&](const std::vector<ParsedChain>& more) {
    for (const ParsedChain& chain : more) {
      if (chain.written.span == parsed.written.span && chain.image == parsed.image) own = chains.size();
      chains.push_back(&chain);
    }
  };
  for (const Event& event : notes_.events) {
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains);
    if (const auto* placed = std::get_if<PlacedDirective>(&event)) take(placed->directive.chains);
  }
  std::vector<TokenView> sides;
  for (std::size_t k = own - std::min(own, before); k < chains.size() && k <= own + behind; ++k) {
    if (k == own) continue;
    for (const WrittenSide& side : chains[k]->written.sides) sides.emplace_back(side.tokens);
  }
  return sides;
}

/// A side that another step supports is less likely to hold the slip.
void Session::suggest_repairs(const ParsedChain& parsed, const Context& context, std::size_t first_step) {
  if (options_.repairs == Repairs::none || parsed.image > 0) return;
  const auto trust = [&](std::size_t step, bool exists) {
    if (!exists) return Trust::unknown;
    const Verdict verdict = report_.steps[step].verdict;
    if (verdict == Verdict::proved) return Trust::supported;
    return verdict == Verdict::refuted ? Trust::doubted : Trust::unknown;
  };
  const std::size_t count = report_.steps.size() - first_step;
  for (std::size_t which = 0; which < count; ++which) {
    Step& step = report_.steps[first_step + which];
    const bool refuted = step.verdict == Verdict::refuted;
    if (!refuted && !is_malformed(step)) continue;
    if (which + 1 < parsed.remainders.size() && parsed.remainders[which + 1]) continue;
    if (step.expected_refuted && options_.repairs == Repairs::of_unexpected) continue;
    const auto start = Clock::now();
    const WrongStep wrong{.parsed = parsed,
                          .which = which,
                          .first_order = context.first_order,
                          .left = trust(first_step + which - 1, which > 0),
                          .right = trust(first_step + which + 1, which + 1 < count),
                          .near = sides_near(parsed)};
    options_.cache->begin(options_.effort);
    step.repairs = nearest_true_statements(tree_, names_, wrong, options_.cache);
    step.repair_milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (refuted) step.conditions = missing_conditions(tree_, names_, wrong, options_.cache);
    step.work = std::max(step.work, options_.cache->budget().used());
  }
}

/// Each expectation is about one refuted step of the next chain, the first ones; cyclic images are the same
/// statement again.
void Session::excuse_refuted(const ParsedChain& parsed, std::size_t first_step) {
  if (parsed.image == 0) in_force_ = std::exchange(expectations_, {});
  std::size_t excused = 0;
  for (std::size_t k = first_step; k < report_.steps.size() && excused < in_force_.size(); ++k) {
    if (report_.steps[k].verdict != Verdict::refuted) continue;
    report_.steps[k].expected_refuted = true;
    ++excused;
  }
  if (parsed.image > 0) return;
  for (; excused < in_force_.size(); ++excused) report_unmet(*in_force_[excused], parsed.written.span);
}

void Session::report_unmet(const Directive& expectation, Span statement) {
  if (!decides()) return;
  report_.diagnostics.push_back({DiagnosticKind::unexpected_verdict,
                                 expectation.span,
                                 "the next statement was expected to be refuted and is not",
                                 {{statement, "this statement"}}});
}

/// An expression without a relation is passed over with a warning, unless it cannot even be read: then it is
/// a step not understood.
bool Session::reads(const ParsedChain& parsed) {
  Step step;
  step.span = step.relation_span = parsed.written.span;
  step.tag = parsed.written.tag;
  step.label = parsed.written.label;
  step.section = section_;
  step.source = written(parsed.written.span);
  std::vector<SyntaxId> pending = parsed.sides;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    const bool named =
        notes_.syntax[id].kind == SyntaxKind::group;  // words at a brace keep nothing from being read
    const auto children = notes_.syntax.children(id);
    for (const SyntaxChild& child : children.first(named ? 1 : children.size())) pending.push_back(child.id);
    if (notes_.syntax[id].kind != SyntaxKind::opaque) continue;
    const Obstacle& obstacle = notes_.syntax.obstacle(id);
    step.diagnostics.push_back({obstacle.kind, notes_.syntax[id].span, obstacle.message, {}, obstacle.help});
  }
  if (step.diagnostics.empty()) return true;
  doubt_errors(notes_.syntax, names_, parsed, 0, step.diagnostics);
  add(std::move(step));
  return false;
}

void Session::mark_seen(const std::vector<Side>& sides) {
  for (const Side& side : sides) {
    if (!side.typed) continue;
    for (const SymbolId symbol : symbols_in(tree_, side.typed->id)) {
      names_.mark_seen(symbol);
      const SymbolId base = base_of(tree_.symbols, symbol);
      names_.mark_seen(base);
      for (const auto& [directive, meant] : for_all_) {
        if (meant == base) names_.mark_used(directive);
      }
    }
  }
}

Step Session::new_step(const ParsedChain& parsed, std::size_t which, const Context& context) const {
  const WrittenChain& chain = parsed.written;
  Step step;
  step.relation_span = chain.relations[which].span;
  step.span = cover(cover(chain.sides[which].span, step.relation_span), chain.sides[which + 1].span);
  step.tag = chain.tag;
  step.label = chain.label;
  step.section = section_;
  step.left = written(chain.sides[which].span);
  step.relation = chain.relations[which].text;
  step.right = written(chain.sides[which + 1].span);
  step.source = fmt::format("{} {} {}", step.left, step.relation, step.right);
  if (context.place) step.span = *context.place;
  if (parsed.image > 0) step.source += fmt::format(" (cyclic image {})", parsed.image);
  return step;
}

void Session::add(Step step) {
  const auto same = [](const Diagnostic& a, const Diagnostic& b) {
    return a.kind == b.kind && a.span == b.span && a.message == b.message;
  };
  Diagnostics once;
  for (Diagnostic& diagnostic : step.diagnostics) {
    const bool known =
        std::any_of(once.begin(), once.end(), [&](const Diagnostic& old) { return same(old, diagnostic); });
    if (!known) once.push_back(std::move(diagnostic));
  }
  step.diagnostics = std::move(once);
  ++report_.counts[static_cast<std::size_t>(step.verdict)];
  report_.steps.push_back(std::move(step));
}

std::string Session::written(Span span) const {
  std::string text;
  for (const char c : sources_.text(span)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      text += c;
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
  }
  return text;
}

std::string Session::place_name(const ParsedChain& parsed) const {
  if (!parsed.written.tag.empty()) return parsed.written.tag;
  return fmt::format("in line {}",
                     sources_.line_column(parsed.written.span.file, parsed.written.span.begin).line);
}

}  // namespace rigor
