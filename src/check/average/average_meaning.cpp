// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/average/average_meaning.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/average/average_value.h"
#include "elaborate/notation/elaborate.h"
#include "expr/calculus/differentiate.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// The letter of each member: E_s of E. Numbers stay; nothing for any other letter.
std::optional<ExprId> of_member(ExprTree& tree, const Names& names, ExprId averaged, ParticleId member) {
  bool known = true;
  bool any = false;
  const ExprId result = replaced(tree, averaged, [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree[id];
    const Symbol& symbol = tree.symbols[node.symbol];
    if (symbol.is_fixed() || is_declared_constant(names.scope, node.symbol)) return std::nullopt;
    const NameKey* key = key_of(names.symbols, node.symbol);
    const auto own = key == nullptr || node.rank != 0 || symbol.derivation || symbol.integral ||
                             definition_of(names.scope, node.symbol) != nullptr
                         ? std::nullopt
                         : find_symbol(names.symbols, {key->base, 0, true});
    known = known && own.has_value();
    if (!own) return std::nullopt;
    any = true;
    return tree.add({.op = Op::symbol, .span = node.span, .symbol = *own, .particle = member});
  });
  return known && any ? std::optional(result) : std::nullopt;
}

/// Is it reckoned from the variable, which it has, and from numbers?
bool is_of_variable_alone(const ExprTree& tree, ExprId averaged, SymbolId variable) {
  const std::vector<SymbolId> letters = symbols_in(tree, averaged);
  return is_one_of(variable, letters) && std::ranges::all_of(letters, [&](SymbolId each) {
           return each == variable || tree.symbols[each].is_fixed();
         });
}

/// The factors of a product with one of them replaced; nothing where it is not there once.
std::optional<ExprId> with_factor(ExprTree& tree, ExprId product, ExprId factor, ExprId by) {
  if (same_expression(tree, product, tree, factor)) return by;
  if (tree[product].op != Op::multiply) return std::nullopt;
  std::vector<ExprId> factors(tree.children(product).begin(), tree.children(product).end());
  const auto is_it = [&](ExprId each) { return same_expression(tree, each, tree, factor); };
  if (std::ranges::count_if(factors, is_it) != 1) return std::nullopt;
  *std::ranges::find_if(factors, is_it) = by;
  return tree.add({.op = Op::multiply, .span = tree[product].span}, factors);
}

/// Of one average, and of the other.
struct Averaged {
  ExprId known{};
  ExprId asked{};
};

std::optional<ExprId> in_sum(ExprTree& tree, const Names& names, ExprId sum, const Averaged& of) {
  const ExprNode node = tree[sum];
  const auto known = of_member(tree, names, of.known, node.particle);
  const auto asked = of_member(tree, names, of.asked, node.particle);
  const auto body = known && asked ? with_factor(tree, tree.children(sum)[0], *known, *asked) : std::nullopt;
  if (!body) return std::nullopt;
  return tree.add({.op = Op::particle_sum, .span = node.span, .particle = node.particle},
                  std::span(&*body, 1));
}

std::optional<ExprId> in_integral(ExprTree& tree, ExprId id, const Averaged& of) {
  const ExprNode node = tree[id];
  Integral integral = *tree.symbols[node.symbol].integral;
  if (integral.average || integral.sum || integral.primitive || !integral.lower) return std::nullopt;
  if (!is_of_variable_alone(tree, of.known, integral.variable) ||
      !is_of_variable_alone(tree, of.asked, integral.variable))
    return std::nullopt;
  const auto integrand = with_factor(tree, integral.integrand, of.known, of.asked);
  if (!integrand) return std::nullopt;
  integral.integrand = *integrand;
  return tree.add(
      {.op = Op::symbol, .span = node.span, .symbol = symbol_of_integral(tree, integral, node.span)});
}

/// The one sum or integral in a product or quotient, replaced.
std::optional<ExprId> replaced_in(ExprTree& tree, const Names& names, ExprId side, const Averaged& of) {
  const ExprNode node = tree[side];
  if (node.op == Op::particle_sum) return in_sum(tree, names, side, of);
  if (node.op == Op::symbol && tree.symbols[node.symbol].integral) return in_integral(tree, side, of);
  if (node.op != Op::multiply && node.op != Op::divide) return std::nullopt;
  std::vector<ExprId> parts(tree.children(side).begin(), tree.children(side).end());
  std::size_t count = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (node.op == Op::divide && k == 1) break;  // what the weights are divided by
    const auto part = replaced_in(tree, names, parts[k], of);
    if (!part) continue;
    parts[k] = *part;
    ++count;
  }
  if (count != 1) return std::nullopt;
  return tree.add({.op = node.op, .span = node.span}, parts);
}

}  // namespace

std::optional<Equation> meaning_of_average(ExprTree& tree, const Names& names, SymbolId average,
                                           const Equation& law) {
  const ExprNode left = tree[law.left];
  const bool plain = law.relation == Relation::equal && law.indices.empty() && law.particles.empty() &&
                     left.op == Op::symbol && is_average(tree, left.symbol) &&
                     !tree.symbols[left.symbol].derivation && left.symbol != average &&
                     tree[law.right].rank == 0;
  if (!plain || has_operators(tree, law.right)) return std::nullopt;
  const Averaged of{tree.symbols[left.symbol].integral->integrand, tree.symbols[average].integral->integrand};
  if (has_operators(tree, of.asked) || tree[of.asked].rank != 0) return std::nullopt;
  const auto right = replaced_in(tree, names, law.right, of);
  if (!right) return std::nullopt;
  return Equation{.left = tree.add({.op = Op::symbol, .span = left.span, .symbol = average}),
                  .right = *right};
}

}  // namespace rigor
