// SPDX-License-Identifier: GPL-3.0-or-later
// A chain: how its sides are read, and its steps one after the other.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "check/session.h"

namespace rigor {

void Session::chain(const ParsedChain& parsed, const Context& context) {
  const std::size_t first_step = report_.steps.size();
  if (parsed.written.relations.empty() && !reads(parsed)) return;
  if (parsed.written.relations.empty()) {
    report_.diagnostics.push_back({DiagnosticKind::no_relation, parsed.written.span,
                                   "no relation stands here, so there is nothing to decide"});
    return;
  }
  const std::unique_ptr<Attempt> attempt = read(parsed);
  for (const std::string& letter : attempt->reading.unsummed) {
    attempt->sides[0].diagnostics.push_back(
        {DiagnosticKind::unsummed_index,
         parsed.written.span,
         fmt::format(
             "index `{}` stands twice in a term and is read as not summed, since it is free elsewhere",
             letter),
         {},
         {"say `(\\text{no sum})` beside the equation"}});
  }
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) step(parsed, k, *attempt, context);
  const std::vector<Side>& sides = attempt->sides;
  mark_seen(sides);
  if (context.role == Role::display || context.role == Role::claim) excuse_refuted(parsed, first_step);
  record_dimensions(parsed, *attempt, context, first_step);
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
  report_.diagnostics.push_back({DiagnosticKind::unexpected_verdict,
                                 expectation.span,
                                 "the next statement was expected to be refuted and is not",
                                 {{statement, "this statement"}}});
}

Session::Attempt::Attempt(Session& session, const ParsedChain& parsed, const Reading& how)
    : reading(how),
      elaborator(session.notes_.syntax, session.tree_, session.names_, session.letters_of(parsed), own, how) {
  for (const SyntaxId id : parsed.sides) {
    Side side;
    side.typed = elaborator.expression(id);
    side.diagnostics = std::exchange(own, {});
    if (sides.empty() && side.typed) elaborator.expect_slots(side.typed->free);
    sides.push_back(std::move(side));
  }
}

/// The plain reading, unless the indices of the sides only fit in another one: a letter that is free on one
/// side is not summed on another, or a prime does not make another letter of it.
std::unique_ptr<Session::Attempt> Session::read(const ParsedChain& parsed) {
  const Reading plain{.no_sum = parsed.written.no_sum};
  auto first = std::make_unique<Attempt>(*this, parsed, plain);
  if (parsed.sides.size() < 2 || is_balanced(first->sides)) return first;
  Reading unsummed = plain;
  const bool all_read = std::all_of(first->sides.begin(), first->sides.end(),
                                    [](const Side& side) { return side.typed.has_value(); });
  for (const Side& side : first->sides) {
    if (!all_read) break;
    for (const FreeIndex& free : side.typed->free) {
      if (first->elaborator.summed_letters().contains(free.letter)) unsummed.unsummed.insert(free.letter);
    }
  }
  Reading primes = plain;
  primes.primes_on_axes = true;
  for (const Reading& other : {unsummed, primes}) {
    const bool differs = !other.unsummed.empty() || other.primes_on_axes;
    if (!differs) continue;
    auto attempt = std::make_unique<Attempt>(*this, parsed, other);
    if (is_balanced(attempt->sides)) return attempt;
  }
  return first;
}

/// All sides are read, and have the same free letters (a number has none and fits all).
bool Session::is_balanced(const std::vector<Side>& sides) const {
  std::optional<std::set<std::string>> first;
  for (const Side& side : sides) {
    if (!side.typed) return false;
    std::set<std::string> own;
    for (const FreeIndex& free : side.typed->free) own.insert(free.letter);
    if (is_literal_zero(tree_, *side.typed)) continue;
    if (first && *first != own) return false;
    first = own;
  }
  return true;
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
    for (const SyntaxChild& child : notes_.syntax.children(id)) pending.push_back(child.id);
    if (notes_.syntax[id].kind != SyntaxKind::opaque) continue;
    const Obstacle& obstacle = notes_.syntax.obstacle(id);
    step.diagnostics.push_back({obstacle.kind, notes_.syntax[id].span, obstacle.message, {}, obstacle.help});
  }
  if (step.diagnostics.empty()) return true;
  add(std::move(step));
  return false;
}

void Session::mark_seen(const std::vector<Side>& sides) {
  for (const Side& side : sides) {
    if (!side.typed) continue;
    for (const SymbolId symbol : symbols_in(tree_, side.typed->id)) {
      names_.mark_seen(symbol);
      if (const auto& derivation = tree_.symbols[symbol].derivation) names_.mark_seen(derivation->base);
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
