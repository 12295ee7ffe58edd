// SPDX-License-Identifier: GPL-3.0-or-later
// A chain with places that can be read in two ways. A malformed reading does not count. Of the others, all
// must prove a step, or all must refute it.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/doubt/row_doubts.h"
#include "check/place/place.h"

namespace rigor {
namespace {

/// Bars, a slash, or where the argument of a function ends.
char notation_of(const Choice& choice) {
  if (choice.first.starts_with("\\frac{")) return '/';
  return choice.first.starts_with("(") ? '|' : 'f';
}

/// Who writes one notation twice in a row means it in one way.
bool is_one_notation(const std::vector<Choice>& choices) {
  return std::ranges::all_of(
      choices, [&](const Choice& choice) { return notation_of(choice) == notation_of(choices.front()); });
}

/// Is it certain that the chain is malformed in this reading?
bool is_nonsense(RowPlace& place, const ParsedChain& parsed, const std::vector<SyntaxId>& sides) {
  ParsedChain chain = parsed;
  chain.sides = sides;
  const auto reading = read_here(place, chain);
  for (std::size_t which = 0; which < chain.written.relations.size(); ++which) {
    Diagnostics found = reading->sides[which].diagnostics;
    const Diagnostics& right = reading->sides[which + 1].diagnostics;
    found.insert(found.end(), right.begin(), right.end());
    if (reading->sides[which].typed && reading->sides[which + 1].typed)
      static_cast<void>(reading->claim(chain, which, false, found));
    doubt_errors(place.notes.syntax, place.names, chain, which, found);
    const bool wrong =
        std::ranges::any_of(found, [](const Diagnostic& each) { return is_malformation(each.kind); });
    if (wrong) return true;
  }
  return false;
}

/// The row in its other reading, as far as it can be read so.
std::optional<Step> settled_otherwise(RowPlace& place, const StepReading& row, const Claim& claim,
                                      const Step& before) {
  if (row.other == nullptr) return std::nullopt;  // brackets were read in several ways already
  ChainReading& reading = *row.other;
  add_used(place, reading.used());
  if (!reading.sides[row.which].typed || !reading.sides[row.which + 1].typed) return std::nullopt;
  Diagnostics mismatches;
  auto other = reading.claim(row.parsed, row.which, claim.nearly, mismatches);
  if (!other) return std::nullopt;
  other->in_both_readings = true;
  Step step = before;
  const StepReading again{.parsed = row.parsed,
                          .which = row.which,
                          .reading = reading,
                          .role = row.role,
                          .first_order = row.first_order};
  settle(place, again, *other, judge_here(place, *other), step);
  return step;
}

}  // namespace

void settle_in_both(RowPlace& place, const StepReading& row, const Claim& claim, Judgement judgement,
                    Step& step) {
  const bool bracket = claim.reading->found.applied.has_value();
  const Step before = step;
  settle(place, row, claim, std::move(judgement), step);
  if (step.verdict == Verdict::proved || claim.recorded != nullptr) return;
  std::vector<StatedLaw>& stated = place.found.stated;
  if (claim.reading->found.applied_elsewhere) {  // nothing but a proof shows that a value is meant
    stated.clear();
    step = before;
    step.verdict = Verdict::not_understood;
    const Obstacle guess = *claim.reading->found.applied;
    step.diagnostics.push_back({guess.kind, claim.relation, guess.message, {}, guess.help});
    return;
  }
  const std::size_t by_first = stated.size();
  const auto other = settled_otherwise(place, row, claim, before);
  if (!other && bracket && step.verdict != Verdict::refuted) return;  // no product can be meant
  if (other && other->verdict == Verdict::proved && !bracket) {
    stated.erase(stated.begin(), stated.begin() + static_cast<std::ptrdiff_t>(by_first));
    step = *other;
    if (row.asked != nullptr) row.asked->question.reset();  // that of the first reading
    return;
  }
  // That a letter of its own is a length is not said, so nothing but a proof shows it.
  if (!bracket && !claim.reading->found.belongs) return stated.resize(by_first);
  // A symbol of its own says the least, so its law is the one that is left.
  if (bracket) {
    stated.resize(by_first);
  } else if (other && other->verdict == Verdict::law) {
    stated.erase(stated.begin(), stated.begin() + static_cast<std::ptrdiff_t>(by_first));
  }
  const bool refutes_a_product = bracket && step.verdict == Verdict::refuted;
  if (other && other->verdict == step.verdict && !refutes_a_product) return;
  stated.clear();
  const auto is_law_or_open = [](const Step& each) {
    return each.verdict == Verdict::law || each.verdict == Verdict::undecided;
  };
  const bool open_in_other = other && is_law_or_open(*other);
  // What is near a row with values of functions holds for products as well, of which it does not follow.
  if (open_in_other && bracket && step.verdict == Verdict::suspect) return;
  if (open_in_other && is_law_or_open(step)) {
    if (other->verdict == Verdict::undecided) step = *other;
    return;
  }
  const auto open = guess_of(*claim.reading);
  const Obstacle guess =
      open ? *open
           : Obstacle{
                 DiagnosticKind::ambiguous_reading, "this can be a product or the value of a function", {}};
  // What the reading that says the least offers holds in both.
  std::vector<Repair> near = bracket ? std::move(step.repairs)
                             : other ? other->repairs
                                     : std::vector<Repair>{};
  step = before;
  step.repairs = std::move(near);
  step.verdict = Verdict::not_understood;
  step.diagnostics.push_back(
      {guess.kind, claim.relation, guess.message + "; the readings have different verdicts", {}, guess.help});
}

Diagnostic two_readings(const ParsedChain& parsed) {
  const Choice& choice = parsed.choices.front();
  return {DiagnosticKind::ambiguous_reading,
          choice.span,
          fmt::format("this can be `{}` or `{}`", choice.first, choice.second),
          {},
          {"put brackets where the argument ends"}};
}

ParsedChain sensible_readings(RowPlace& place, const ParsedChain& parsed) {
  std::vector<std::vector<SyntaxId>> sensible;
  if (!is_nonsense(place, parsed, parsed.sides)) sensible.push_back(parsed.sides);
  for (const std::vector<SyntaxId>& other : parsed.others) {
    if (!is_nonsense(place, parsed, other)) sensible.push_back(other);
  }
  ParsedChain chain = parsed;
  chain.others.clear();
  if (!sensible.empty()) {
    chain.sides = sensible.front();
    chain.others.assign(sensible.begin() + 1, sensible.end());
  }
  if (chain.others.empty()) chain.choices.clear();
  return chain;
}

void decide_in_all_readings(RowPlace& place, const StepReading& row, const Claim& claim, Step& step) {
  const ParsedChain& parsed = row.parsed;
  const std::size_t which = row.which;
  Judgement first = judge_here(place, claim);
  constexpr std::size_t most_places = 2;  // all its readings were tried
  const bool uniform = is_one_notation(parsed.choices);
  const bool all_tried = parsed.choices.size() <= most_places;
  bool agree = first.verdict == Verdict::refuted ? all_tried : all_tried || uniform;
  // a recorded sample belongs to the first reading; the others were looked at when it was found
  for (const std::vector<SyntaxId>& sides : parsed.others) {
    if (claim.recorded != nullptr || !agree) break;
    const bool mixed = &sides != parsed.others.data();
    if (mixed && uniform && first.verdict == Verdict::proved) break;
    ParsedChain chain = parsed;
    chain.sides = sides;
    const auto reading = read_here(place, chain);
    Diagnostics mismatches;
    const bool typed = reading->sides[which].typed && reading->sides[which + 1].typed;
    const auto other = typed ? reading->claim(chain, which, claim.nearly, mismatches) : std::nullopt;
    agree = other && judge_here(place, *other).verdict == first.verdict;
  }
  if (agree) {
    accept(std::move(first), step);
    return;
  }
  step.verdict = Verdict::not_understood;
  step.diagnostics.push_back(two_readings(parsed));
  step.diagnostics.back().message += "; the readings have different verdicts";
}

}  // namespace rigor
