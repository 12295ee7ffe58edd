// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/base_letters.h"

#include <vector>

#include "base/among.h"

namespace rigor {
namespace {

/// What only runs from one limit of an integral to the other: `x = \sin t` says nothing about
/// `\int_0^1\cos t\,dt`.
bool only_runs(const ExprTree& tree, SymbolId letter, const std::vector<SymbolId>& reached,
               const std::vector<SymbolId>& outside) {
  if (is_one_of(letter, outside)) return false;
  bool runs = false;
  for (const SymbolId symbol : reached) {
    const auto& integral = tree.symbols[base_of(tree.symbols, symbol)].integral;
    if (!integral || !integral->lower || !integral->upper) continue;
    runs = runs || integral->variable == letter;
    for (const Limit& limit : {*integral->lower, *integral->upper}) {
      if (limit.at && is_one_of(letter, symbols_in(tree, *limit.at))) return false;
    }
  }
  return runs;
}

}  // namespace

std::set<SymbolId> base_letters(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  const std::vector<ExprId> sides{equation.left, equation.right};
  const std::vector<SymbolId> reached = symbols_reached(tree, scope, sides);
  const std::vector<SymbolId> outside = symbols_reached(
      tree, sides, [&](SymbolId symbol) { return body_of_definition(scope, base_of(tree.symbols, symbol)); });
  std::set<SymbolId> letters;
  for (const SymbolId symbol : reached) {
    if (!only_runs(tree, symbol, reached, outside)) letters.insert(base_of(tree.symbols, symbol));
  }
  return letters;
}

std::vector<ExprId> nodes_reached(const ExprTree& tree, const NameScope& scope, std::vector<ExprId> roots) {
  for (const SymbolId symbol : symbols_reached(tree, scope, roots)) {
    if (const auto body = body_of_definition(scope, symbol)) roots.push_back(*body);
  }
  return nodes_below(tree, roots);
}

std::set<SymbolId> written_letters(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> letters;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) letters.insert(base_of(tree.symbols, symbol));
  }
  return letters;
}

}  // namespace rigor
