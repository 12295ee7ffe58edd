// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/counted_letter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "base/among.h"
#include "check/question/whole_number.h"
#include "elaborate/name/function_value.h"
#include "elaborate/notation/elaborate.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr int largest_first = 8;

/// The sums that a claim speaks of, also inside each other and in definitions.
std::vector<Integral> sums_of(const ExprTree& tree, const Names& names, const Equation& claim) {
  std::vector<Integral> sums;
  for (const SymbolId symbol : symbols_reached(tree, names.scope, {claim.left, claim.right})) {
    const auto& integral = tree.symbols[base_of(tree.symbols, symbol)].integral;
    if (integral && integral->sum && integral->lower && integral->upper) sums.push_back(*integral);
  }
  return sums;
}

ExprId with_number(ExprTree& tree, ExprId id, SymbolId letter, int number) {
  return replaced(tree, id, [&](ExprId node) -> std::optional<ExprId> {
    if (tree[node].symbol != letter) return std::nullopt;
    return tree.add_number(tree[node].span, std::to_string(number));
  });
}

}  // namespace

bool counts_to_letters(const ExprTree& tree, const Names& names, const Equation& claim) {
  return std::ranges::any_of(sums_of(tree, names, claim), [&](const Integral& sum) {
    const auto open = [&](const Limit& limit) { return limit.at && !symbols_in(tree, *limit.at).empty(); };
    return open(*sum.lower) || open(*sum.upper);
  });
}

std::optional<CountedLetter> counted_letter(ExprTree& tree, const Names& names, const Equation& claim) {
  const std::vector<Integral> sums = sums_of(tree, names, claim);
  std::set<SymbolId> letters;
  CountedLetter result;
  for (const Integral& sum : sums) {
    for (const Limit& limit : {*sum.lower, *sum.upper}) {
      if (!limit.at) continue;
      for (const SymbolId letter : symbols_in(tree, *limit.at)) letters.insert(letter);
    }
    result.by_induction = result.by_induction && sum.lower->at && symbols_in(tree, *sum.lower->at).empty();
  }
  for (const Integral& sum : sums) letters.erase(sum.variable);
  if (letters.size() != 1) return std::nullopt;
  result.letter = *letters.begin();
  const Symbol& symbol = tree.symbols[result.letter];
  if (symbol.rank > 0 || symbol.per_particle || symbol.derivation || symbol.integral || symbol.is_fixed() ||
      definition_of(names.scope, result.letter) != nullptr)
    return std::nullopt;
  const auto is_said = [&](const NamedAssumption& each) {
    return is_one_of(result.letter, symbols_in(tree, each.equation.left)) ||
           is_one_of(result.letter, symbols_in(tree, each.equation.right));
  };
  const auto is_defined = [&](SymbolId each) { return definition_of(names.scope, each) != nullptr; };
  for (const ExprId side : {claim.left, claim.right})
    result.by_induction = result.by_induction && std::ranges::none_of(letters_in(tree, side), is_defined);
  result.by_induction = result.by_induction && std::ranges::none_of(names.scope.assumptions, is_said);
  for (int number = 0; number <= largest_first; ++number) {
    const bool full = std::ranges::all_of(sums, [&](const Integral& sum) {
      if (!sum.lower->at || !sum.upper->at) return true;
      const auto lower = whole_number_of(tree, with_number(tree, *sum.lower->at, result.letter, number));
      const auto upper = whole_number_of(tree, with_number(tree, *sum.upper->at, result.letter, number));
      return !lower || !upper || *lower <= *upper;
    });
    if (!full) continue;
    result.first = number;
    return result;
  }
  return std::nullopt;
}

Names at_number(ExprTree& tree, const Names& names, SymbolId letter, int number) {
  Names with = names;
  const Span span = tree.symbols[letter].first_seen;
  define(with.scope, {.definition = {letter, {}, no_particle, tree.add_number(span, std::to_string(number))},
                      .origin = Origin{fmt::format("`{}` = {}", tree.symbols[letter].name, number), ""}});
  return with;
}

std::optional<Equation> advanced(ExprTree& tree, const Equation& claim, SymbolId letter) {
  bool plain = true;
  const auto is_letter = [&](ExprId id) { return is_one_of(letter, letters_in(tree, id)); };
  const auto next = [&](ExprId id) -> std::optional<ExprId> {
    if (tree[id].symbol != letter) return std::nullopt;
    const std::array parts{id, tree.add_number(tree[id].span, "1")};
    return tree.add({.op = Op::add, .span = tree[id].span}, parts);
  };
  const auto of_symbol = [&](ExprId id) -> std::optional<ExprId> {
    const Symbol& symbol = tree.symbols[base_of(tree.symbols, tree[id].symbol)];
    if (!symbol.integral) return next(id);
    Integral sum = *symbol.integral;
    const bool speaks = std::ranges::any_of(parts_of(sum), is_letter);
    if (!speaks) return std::nullopt;
    plain = plain && sum.sum && !symbol.derivation && sum.variable != letter && !is_letter(sum.integrand) &&
            tree[id].symbol == base_of(tree.symbols, tree[id].symbol);
    if (!plain) return std::nullopt;
    for (Limit* limit : {&*sum.lower, &*sum.upper}) {
      if (limit->at) limit->at = replaced(tree, *limit->at, next);
    }
    const Span span = tree[id].span;
    return tree.add({.op = Op::symbol, .span = span, .symbol = symbol_of_integral(tree, sum, span)});
  };
  Equation result = claim;
  result.left = replaced(tree, claim.left, of_symbol);
  result.right = replaced(tree, claim.right, of_symbol);
  return plain ? std::optional(result) : std::nullopt;
}

}  // namespace rigor
