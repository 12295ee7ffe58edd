// SPDX-License-Identifier: GPL-3.0-or-later
// `e^x = 1 + x + O(x^2)`: the sides are compared as power series, coefficient by coefficient below the order.
// O(x^n) is a set of functions, and `=` says that the left side is in the set on the right: so the step is
// not symmetric, and a left side with a lower order is in no smaller set.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "check/doubt/row_doubts.h"
#include "check/place/place.h"
#include "check/question/decision_cache.h"
#include "check/repair/repair.h"
#include "check/repair/sides_near.h"
#include "check/row/series_equation.h"
#include "check/scope/definition.h"

namespace rigor {
namespace {

/// The degree as a polynomial in the symbol; more than any order if it is not one.
int degree(const ExprTree& tree, ExprId id, SymbolId symbol) {
  constexpr int none = 1000;
  const std::vector<SymbolId> inside = symbols_in(tree, id);
  if (!is_one_of(symbol, inside)) return 0;
  const ExprNode& node = tree[id];
  int found = 0;
  switch (node.op) {
    case Op::symbol:
      return 1;
    case Op::add:
    case Op::negate:
    case Op::tuple:
      for (const ExprId child : tree.children(id)) found = std::max(found, degree(tree, child, symbol));
      return found;
    case Op::multiply:
    case Op::dot:
    case Op::cross:
      for (const ExprId child : tree.children(id)) found += degree(tree, child, symbol);
      return std::min(found, none);
    case Op::divide:
      return degree(tree, tree.children(id)[1], symbol) > 0 ? none
                                                            : degree(tree, tree.children(id)[0], symbol);
    case Op::power:
      return node.exponent < 0 ? none
                               : std::min(none, node.exponent * degree(tree, tree.children(id)[0], symbol));
    default:
      return none;
  }
}

/// Is the letter counted with, or can it be said to be large here?
bool may_be_large(const RowPlace& place, const std::string& letter) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  const std::string words = beside.lead + " " + beside.tail;
  const auto says = [&](const char* word) { return words.find(word) != std::string::npos; };
  if (letter == "n" || letter == "N" || says("infinity") || says("large") || says("asymptotic")) return true;
  const auto grows = [&](Span span) {
    const std::string_view text = place.sources.text(span);
    return text.find("\\infty") != std::string_view::npos || text.find("\\gg") != std::string_view::npos;
  };
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display != nullptr && grows(display->span)) return true;
  return std::ranges::any_of(place.notes.prose.sentences, [&](const auto& sentence) {
    return sentence.place == beside.place && std::ranges::any_of(sentence.maths, grows);
  });
}

/// The tokens of a side without `+ O(x^n)`, and those of that; nothing where it is not written so.
struct CutSide {
  Tokens rest;
  std::string remainder;
};
std::optional<CutSide> without_remainder(TokenView side) {
  for (const SideTerm& term : terms_of_side(side)) {
    const bool signed_one = term.with_sign.data() != term.tokens.data();
    if (!signed_one || term.tokens[0].text != "O" || !is_sign_at(term.tokens, 1, "(")) continue;
    const auto begin = term.with_sign.data() - side.data();
    const auto end = begin + static_cast<std::ptrdiff_t>(term.with_sign.size());
    Tokens rest(side.begin(), side.begin() + begin);
    rest.insert(rest.end(), side.begin() + end, side.end());
    const TokenView bare = trim(rest);
    return CutSide{Tokens(bare.begin(), bare.end()), text_of(term.with_sign)};
  }
  return std::nullopt;
}

/// The nearest statements that hold up to the order, with the remainder at their end.
std::vector<Repair> repairs_up_to_order(RowPlace& place, ParsedChain pair, SymbolId letter, int power) {
  constexpr std::uint64_t most_work = 2'000'000;
  const auto cut = without_remainder(without_layout(pair.written.sides[1].tokens));
  if (!cut) return {};
  pair.written.sides[1].tokens = cut->rest;
  const WrongStep wrong{.parsed = pair, .near = sides_near(place.notes, pair)};
  DecisionCache* cache = place.options.cache;
  const ShareOfWork share(*cache, most_work);
  const Asked up_to_order = [&](ExprTree& tree, const Names& names, const Equation& equation) {
    return equation_up_to({tree, names, cache}, equation, letter, power);
  };
  const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim,
                                   Slip) -> std::optional<std::vector<std::string>> {
    Claim part = claim;
    const auto equation = up_to_order(tree, names, claim.equation);
    if (!equation) return std::nullopt;
    part.equation = *equation;
    Judgement judgement = judge(tree, names, part, limits_of_candidates, cache);
    if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
    return std::move(judgement.uses);
  };
  std::vector<Repair> repairs;
  for (TrueNeighbour& each : true_neighbours(place.tree, place.names, wrong, proof, cache, up_to_order)) {
    const std::string end = " " + cut->remainder;
    each.repair.statement += end;
    if (!each.repair.on_left) {
      each.repair.replaced += end;
      each.repair.replacement += end;
    }
    each.repair.uses = std::move(each.uses);
    repairs.push_back(std::move(each.repair));
  }
  return repairs;
}

}  // namespace

bool is_up_to_order(const StepReading& row) {
  const ParsedChain& parsed = row.parsed;
  return is_claimed(row.role) && !parsed.written.condition && row.which + 1 < parsed.remainders.size() &&
         parsed.remainders[row.which + 1] && parsed.others.empty() &&
         row.relation().kind == RelationKind::equal;
}

void decide_up_to_order(RowPlace& place, const StepReading& row, Step& step) {
  const ParsedChain& parsed = row.parsed;
  const std::size_t which = row.which;
  const auto& left_end = parsed.remainders[which];
  const auto& right_end = parsed.remainders[which + 1];
  const WrittenRelation relation = row.relation();
  const auto open = [&](std::string message, std::vector<std::string> help = {}) {
    step.diagnostics.push_back(
        {DiagnosticKind::unsupported, relation.span, std::move(message), {}, std::move(help)});
  };
  ParsedChain pair = parsed;
  pair.written.sides = {parsed.written.sides[which], parsed.written.sides[which + 1]};
  pair.written.relations = {relation};
  pair.sides = {left_end ? left_end->rest : parsed.sides[which], right_end->rest};
  pair.remainders.clear();
  const auto reading = read_here(place, pair);
  const auto letter = reading->read(right_end->letter);
  const auto other = left_end ? reading->read(left_end->letter) : letter;
  add_used(place, reading->used());
  if (reading->reading().found.values) return open("a value of a function up to an order is not decided");
  const StepReading without_orders{
      .parsed = pair, .reading = *reading, .role = row.role, .first_order = row.first_order};
  const Side& left = reading->sides[0];
  const Side& right = reading->sides[1];
  if (!letter || !other || !left.typed || !right.typed) {
    for (const Side* side : {&left, &right})
      step.diagnostics.insert(step.diagnostics.end(), side->diagnostics.begin(), side->diagnostics.end());
    if (step.diagnostics.empty()) return open("the letter in `O(…)` is not read");
    return;
  }
  const ExprNode node = place.tree[letter->id];
  const bool plain = node.op == Op::symbol && node.rank == 0 && node.slot_count == 0 &&
                     node.particle == no_particle && !place.tree.symbols[node.symbol].derivation;
  if (!plain) return open("`O(…)` is read only with a power of one letter");
  if (place.tree[other->id].op != Op::symbol || place.tree[other->id].symbol != node.symbol ||
      (left_end && left_end->power < right_end->power))
    return open("the left side is not known to the order of the right side");
  const std::string& name = place.tree.symbols[node.symbol].name;
  const bool small = std::ranges::any_of(place.names.scope.small, [&](const SmallQuantity& each) {
    if (place.tree[each.quantity].symbol != node.symbol) return false;
    place.found.used.insert(each.directive);
    return true;
  });
  const auto ends_below = [&](const std::optional<Remainder>& end, const Side& side) {
    return end && !end->alone && degree(place.tree, side.typed->id, node.symbol) < end->power;
  };
  const bool about_zero =
      small || ((ends_below(left_end, left) || ends_below(right_end, right)) && !may_be_large(place, name));
  if (!about_zero)
    return open(fmt::format("nothing says whether `{}` is small here or large", name),
                {fmt::format("`rigor: small {}` says that it is small", name)});
  if (which == 0 && would_define(place.tree, place.names.scope, *left.typed, *right.typed))
    return open(fmt::format("this may say what `{}` is, up to that order",
                            written_at(place, parsed.written.sides[0].span)));
  Diagnostics mismatches;
  auto claim = reading->claim(pair, 0, false, mismatches);
  step.diagnostics.insert(step.diagnostics.end(), mismatches.begin(), mismatches.end());
  if (!claim) {
    doubt_errors(place.notes.syntax, place.names, pair, 0, step.diagnostics);
    return;
  }
  const SeriesPlace at{place.tree, place.names, place.options.cache, &place.found.used};
  const auto held = with_letter_open(at, claim->equation, node.symbol);
  if (!held) return open(fmt::format("other statements about `{}` keep it from going to 0 by itself", name));
  const auto equations = coefficients(at, *held, node.symbol, right_end->power);
  if (!equations) return open(fmt::format("a side has no known expansion in powers of `{}`", name));
  // An equation that is a law and no identity is no identity up to an order, either.
  std::optional<Judgement> whole;
  if (row.recorded == nullptr) whole = judge_here(place, *claim);
  if (whole && whole->verdict == Verdict::proved) {
    accept(*std::move(whole), step);
    return;
  }
  std::vector<SymbolId> letters = symbols_in(place.tree, held->left);
  for (const SymbolId symbol : symbols_in(place.tree, held->right)) letters.push_back(symbol);
  const bool no_other = std::ranges::all_of(letters, [&](SymbolId symbol) { return symbol == node.symbol; });
  const bool occurs = is_one_of(node.symbol, letters);
  const bool identity = !whole || (occurs && (whole->verdict == Verdict::refuted || no_other));
  Judgement result;
  result.verdict = Verdict::proved;
  std::optional<Judgement> first_open;
  for (const SeriesEquation& each : *equations) {
    Claim part = *claim;
    part.equation = each.equation;
    part.recorded = row.recorded;
    Judgement judgement = judge_here(place, part);
    if (judgement.verdict == Verdict::refuted && identity)
      heed_surroundings(place, without_orders, part, judgement);
    if (judgement.verdict == Verdict::proved) {
      for (std::string& use : judgement.uses) {
        if (!is_one_of(use, result.uses)) result.uses.push_back(std::move(use));
      }
      result.question = std::move(judgement.question);
      continue;
    }
    const std::string power = each.order == 1  ? name
                              : each.order < 0 ? fmt::format("{}^{{{}}}", name, each.order)
                                               : fmt::format("{}^{}", name, each.order);
    const std::string what = each.order == 0 ? fmt::format("the parts without `{}`", name)
                                             : fmt::format("the coefficients of `{}`", power);
    if (judgement.verdict == Verdict::refuted && identity) {
      for (Diagnostic& diagnostic : judgement.diagnostics) {
        const std::string sides = "the sides differ";
        if (diagnostic.kind == DiagnosticKind::refuted && diagnostic.message.starts_with(sides))
          diagnostic.message.replace(0, sides.size(), what + " differ");
      }
      const bool wrong = judgement.verdict == Verdict::refuted && !left_end;
      accept(std::move(judgement), step);
      if (wrong && place.options.repairs != Repairs::none)
        step.repairs = repairs_up_to_order(place, pair, node.symbol, right_end->power);
      return;
    }
    if (!first_open) first_open = std::move(judgement);
  }
  if (!first_open) {
    result.route = fmt::format("power series, up to `{}^{}`", name, right_end->power);
    accept(std::move(result), step);
    return;
  }
  accept(identity ? *std::move(first_open) : *std::move(whole), step);
  if (!left_end && is_told_what_is_near(place, row, step.verdict))
    step.repairs = repairs_up_to_order(place, pair, node.symbol, right_end->power);
}

}  // namespace rigor
