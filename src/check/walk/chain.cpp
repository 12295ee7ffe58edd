// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/walk/topics.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "check/doubt/row_doubts.h"
#include "check/row/row.h"
#include "check/scope/local_kinds.h"
#include "elaborate/name/function_value.h"

namespace rigor {
namespace {

/// The chain as it is read here; what that looks up is used.
std::unique_ptr<ChainReading> read_here(Walk& walk, const ParsedChain& parsed, const ReadingRules& how = {}) {
  auto reading = read_chain(walk.notes.syntax, walk.tree, walk.names, parsed, how);
  add_used(walk, reading->used());
  return reading;
}

/// A chain with an open letter or bracket is read once more. Where it is a bracket, the first reading becomes
/// the one that says the least.
std::unique_ptr<ChainReading> read_otherwise(Walk& walk, const ParsedChain& parsed,
                                             std::unique_ptr<ChainReading>& reading) {
  const Reading::Found& found = reading->reading().found;
  const bool orders =
      std::ranges::any_of(parsed.remainders, [](const auto& remainder) { return remainder.has_value(); });
  if (orders || !parsed.others.empty() || walk.request.only) return nullptr;
  if (!found.applied && found.belongs) return read_here(walk, parsed, {.apart = true});
  if (!found.applied)
    return found.may_be_length ? read_here(walk, parsed, {.lengths_of_other_sections = true}) : nullptr;
  auto product = read_here(walk, parsed, {.open = OpenBracket::factor});
  reading = read_here(walk, parsed, {.apart = true, .open = OpenBracket::argument});
  return product;
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

/// Each expectation is about one step of the next chain with this verdict, the first ones; cyclic images are
/// the same statement again.
void meet_expectations(Walk& walk, const ParsedChain& parsed, std::size_t first_step) {
  if (parsed.image == 0) walk.next.in_force = std::exchange(walk.next.expectations, {});
  std::set<std::size_t> met;
  for (const Directive* expectation : walk.next.in_force) {
    std::size_t k = first_step;
    const auto meets = [&] {
      return walk.report.steps[k].verdict == expectation->expected && !met.contains(k);
    };
    while (k < walk.report.steps.size() && !meets()) ++k;
    if (k < walk.report.steps.size()) {
      met.insert(k);
      walk.report.steps[k].expected_refuted = expectation->expected != Verdict::law;
    } else if (parsed.image == 0) {
      report_unmet(walk, *expectation, parsed.written.span);
    }
  }
}

/// An expression without a relation is passed over with a warning, unless it cannot even be read: then it is
/// a step not understood.
bool reads_expression(Walk& walk, const ParsedChain& parsed) {
  Step step;
  step.span = step.relation_span = parsed.written.span;
  step.tag = parsed.written.tag;
  step.label = parsed.written.label;
  step.section = walk.section;
  step.source = written_at(walk.sources, parsed.written.span);
  std::vector<SyntaxId> pending = parsed.sides;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    const bool named =
        walk.notes.syntax[id].kind == SyntaxKind::group;  // words at a brace keep nothing from being read
    const auto children = walk.notes.syntax.children(id);
    for (const SyntaxChild& child : children.first(named ? 1 : children.size())) pending.push_back(child.id);
    if (walk.notes.syntax[id].kind != SyntaxKind::opaque) continue;
    const Obstacle& obstacle = walk.notes.syntax.obstacle(id);
    step.diagnostics.push_back(
        {obstacle.kind, walk.notes.syntax[id].span, obstacle.message, {}, obstacle.help});
  }
  if (step.diagnostics.empty()) return true;
  doubt_errors(walk.notes.syntax, walk.names, parsed, 0, step.diagnostics);
  add_step(walk, std::move(step));
  return false;
}

/// `r^2E = r^3F`, where `\mathbf r` stands in another row: that r is its length is a guess, and no row has
/// shown the vector.
bool is_guessed(const Walk& walk, const Reading& reading, SymbolId symbol) {
  if (!reading.found.belongs || walk.tree.symbols[symbol].rank == 0) return false;
  const NameKey* key = key_of(walk.names.symbols, symbol);
  return key != nullptr && !reading.letters.bold_vectors.contains(key->base) &&
         !reading.letters.indexed_vectors.contains(key->base);
}

/// A letter whose average alone was written can still be defined below.
void mark_seen(Walk& walk, const ChainReading& reading) {
  for (const ChainReading::Side& side : reading.sides) {
    if (!side.typed) continue;
    for (const SymbolId symbol : letters_in(walk.tree, side.typed->id, false)) {
      const SymbolId base = base_of(walk.tree.symbols, symbol);
      if (is_guessed(walk, reading.reading(), base)) continue;
      mark_seen(walk.names.scope, symbol);
      mark_seen(walk.names.scope, base);
      for (const auto& [directive, meant] : walk.for_all) {
        if (meant == base) walk.used.insert(directive);
      }
    }
  }
}

/// For those who show how the notes are read.
HowRead how_it_was_read(const Walk& walk, const ParsedChain& parsed, ChainReading& reading,
                        const Context& context) {
  const Reading::Found& found = reading.reading().found;
  HowRead how{.conventions = found.conventions,
              .summed = found.summed_letters,
              .open = found.applied ? found.applied : guess_of(reading.reading()),
              .is_stated = expects_law(walk)};
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
    Diagnostics ignored;
    const bool both = reading.sides[k].typed && reading.sides[k + 1].typed;
    const auto claim = both ? reading.claim(parsed, k, context.first_order, ignored) : std::nullopt;
    how.equations.push_back(claim ? std::optional(claim->equation) : std::nullopt);
  }
  return how;
}

void take_chain(Walk& walk, const ParsedChain& parsed, const Context& context) {
  const std::size_t first_step = walk.report.steps.size();
  if (parsed.written.relations.empty() && !reads_expression(walk, parsed)) return;
  if (parsed.written.relations.empty()) {
    walk.report.diagnostics.push_back({DiagnosticKind::no_relation, parsed.written.span,
                                       "there is no relation here, so there is nothing to decide"});
    return;
  }
  CaseInForce in_force = enter_case(walk, parsed, context);
  std::unique_ptr<ChainReading> reading = read_here(walk, parsed);
  std::optional<LocalKinds> local;  // where only kinds of another section make it wrong
  if (context.role == Role::display && !fits(parsed, *reading)) {
    local.emplace(walk.notes, walk.names, walk.event);
    add_used(walk, local->used());
    auto own = local->borrowed_letter(walk.notes.syntax, parsed) ? read_here(walk, parsed) : nullptr;
    if (own && fits(parsed, *own)) {
      reading = std::move(own);
    } else {
      local.reset();
    }
  }
  std::unique_ptr<ChainReading> other;
  if (context.role == Role::display && !expects_refuted(walk, parsed))
    other = read_otherwise(walk, parsed, reading);
  reading->for_all = context.role == Role::claim || expects_refuted(walk, parsed);
  for (const std::string& letter : reading->how().unsummed) {
    reading->sides[0].diagnostics.push_back(
        {DiagnosticKind::unsummed_index,
         parsed.written.span,
         fmt::format(
             "index `{}` occurs twice in a term and is read as not summed, since it is free elsewhere",
             letter),
         {},
         {"write `(\\text{no sum})` next to the equation"}});
  }
  heed_other_places(walk, in_force);
  std::vector<WrittenStep> asked(walk.request.explains ? parsed.written.relations.size() : 0);
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k)
    take_step(walk, parsed, k, *reading, other.get(), context, asked.empty() ? nullptr : &asked[k]);
  if (walk.options.recorded == nullptr && decides(walk) && !context.first_order) {
    RowPlace place = place_here(walk);
    explain_slips(place, parsed, *reading, first_step, std::span(walk.report.steps).subspan(first_step));
    take_over(walk, std::move(place.found));
  }
  const std::vector<Side>& sides = reading->sides;
  if (parsed.others.empty()) mark_seen(walk, *reading);
  HowRead how;
  if (walk.request.reads) how = how_it_was_read(walk, parsed, *reading, context);
  if (is_claimed(context.role)) meet_expectations(walk, parsed, first_step);
  const auto guess = guess_of(reading->reading());
  Statement statement{.chain = &parsed,
                      .event = walk.event,
                      .role = context.role,
                      .first_order = context.first_order,
                      .for_now = is_for_now(walk, context),
                      .guessed = guess && guess->kind == DiagnosticKind::ambiguous_reading,
                      .rules = rules_for_like(reading->how()),
                      .how = std::move(how),
                      .first_step = first_step,
                      .step_count = walk.report.steps.size() - first_step,
                      .asked = std::move(asked)};
  for (const Side& side : sides) statement.sides.push_back(side.typed);
  walk.ledger.entries.push_back({scope_here(walk), std::move(statement)});
  leave_case(walk, std::move(in_force));
}

}  // namespace

void follow_chain(Walk& walk, const ParsedChain& parsed, const Context& context) {
  if (walk.request.only && !walk.request.only->contains(&parsed)) {
    ++walk.ledger.passed_over;
    return;
  }
  if (!parsed.others.empty()) {
    RowPlace place = place_here(walk);
    walk.ledger.chains.push_back(sensible_readings(place, parsed));
    take_over(walk, std::move(place.found));
  }
  take_chain(walk, parsed.others.empty() ? parsed : walk.ledger.chains.back(), context);
}

void report_unmet(Walk& walk, const Directive& expectation, Span statement) {
  if (!decides(walk)) return;
  walk.report.diagnostics.push_back(
      {DiagnosticKind::unexpected_verdict,
       expectation.span,
       fmt::format("the next statement was expected to be {} and is not",
                   expectation.expected == Verdict::law ? "a law" : name_of(expectation.expected)),
       {{statement, "this statement"}}});
}

}  // namespace rigor
