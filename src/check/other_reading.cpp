// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/other_reading.h"

#include <fmt/format.h>

#include "check/beyond_reals.h"
#include "check/both_orders.h"
#include "check/law_diagnostic.h"
#include "check/ordered_product.h"

namespace rigor {
namespace {

OtherReading says(const ExprTree& tree, const std::set<SymbolId>& symbols, std::string message,
                  std::string_view what = "a number") {
  const std::string& first = tree.symbols[*symbols.begin()].name;
  return {std::move(message),
          {fmt::format("`rigor: scalar {}` says that {} {}", first,
                       symbols.size() == 1 ? "it is" : "the first is", what)}};
}

std::string quoted(const ExprTree& tree, const std::set<SymbolId>& symbols) {
  return quoted_names(tree, {symbols.begin(), symbols.end()});
}

/// Matrices and operators were multiplied as numbers are: what is proved counts where it holds in their
/// order as well, and nothing is refuted.
std::optional<OtherReading> in_order(const Question& question, const Names& names, bool proved) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  std::set<SymbolId> ordered = ordered_symbols(tree, names, question);
  ordered.merge(symbols_in_both_orders(tree, names, claim));
  if (ordered.empty()) return std::nullopt;
  if (proved && claim.relation == Relation::equal &&
      (equal_in_order(question, ordered) || is_linear_in(question, ordered)))
    return std::nullopt;
  const bool one = ordered.size() == 1;
  return says(tree, ordered,
              fmt::format("{} can be {}, which need not commute, or {}; it {} for numbers",
                          quoted(tree, ordered), one ? "a matrix or an operator" : "matrices or operators",
                          one ? "a number" : "numbers", proved ? "holds" : "does not hold"));
}

/// A claim that real numbers refute is refuted for complex ones, too.
std::optional<OtherReading> in_complex_numbers(const Question& question, const Names& names, bool proved) {
  if (!proved) return std::nullopt;
  const std::set<SymbolId> complex = complex_symbols(question, names);
  if (holds_for_complex(question, complex)) return std::nullopt;
  return says(*question.tree, complex,
              fmt::format("{} can be complex, and it is proved for real numbers only",
                          quoted(*question.tree, complex)),
              "a real number");
}

bool is_capital(const NameKey& key) {
  return key.rank == 0 && key.base[0] >= 'A' && key.base[0] <= 'Z' &&
         (key.base.size() == 1 || key.base[1] == '_');
}

/// `(I - P)^2 = I - 2P + P^2` between capitals, of which nothing says what they are.
std::optional<OtherReading> with_unit_matrix(const Question& question, const Names& names, bool proved) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  if (proved || claim.relation != Relation::equal) return std::nullopt;
  std::set<SymbolId> letters;
  for (const ExprId side : {claim.left, claim.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) letters.insert(symbol);
  }
  std::optional<SymbolId> unit;
  for (const SymbolId symbol : letters) {
    const NameKey* key = names.key_of(symbol);
    if (key == nullptr || !is_capital(*key)) return std::nullopt;
    const bool open = !tree.symbols[symbol].declared && names.definition_of(symbol) == nullptr;
    if (open && (key->base == "I" || key->base == "E")) unit = symbol;
  }
  if (!unit || letters.size() < 2 || !equal_with_units(tree, claim.left, claim.right, {*unit}, {*unit}))
    return std::nullopt;
  return says(
      tree, {*unit},
      fmt::format("{} can be the unit matrix, with which it holds, or a number, for which it does not",
                  quoted(tree, {*unit})));
}

std::optional<OtherReading> in_determinants(const Question& question, const Names& names, bool proved) {
  const std::set<SymbolId> matrices = symbols_of_determinants(question, names);
  if (matrices.empty()) return std::nullopt;
  return says(*question.tree, matrices,
              fmt::format("{} can be {}, and the bars a determinant; it {} for numbers",
                          quoted(*question.tree, matrices), matrices.size() == 1 ? "a matrix" : "matrices",
                          proved ? "holds" : "does not hold"));
}

}  // namespace

std::optional<OtherReading> other_reading(const Question& question, const Names& names, bool proved) {
  if (auto order = in_order(question, names, proved)) return order;
  if (auto complex = in_complex_numbers(question, names, proved)) return complex;
  if (auto unit = with_unit_matrix(question, names, proved)) return unit;
  return in_determinants(question, names, proved);
}

bool holds_with_unit_matrix(const Question& question, const Names& names) {
  if (names.evidence.units.empty() || question.claim.relation != Relation::equal) return false;
  const ExprTree& tree = *question.tree;
  const std::set<SymbolId> ordered = ordered_symbols(tree, names, question);
  const std::set<SymbolId> units = unit_matrices(names, question, ordered);
  return !units.empty() && equal_with_units(tree, question.claim.left, question.claim.right, ordered, units);
}

}  // namespace rigor
