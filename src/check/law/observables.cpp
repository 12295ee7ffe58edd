// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/observables.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "check/question/base_letters.h"

namespace rigor {
namespace {

std::optional<SymbolId> bare_operator(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  const bool bare = node.op == Op::symbol && node.slot_count == 0 && tree.symbols[node.symbol].noncommuting;
  return bare ? std::optional(node.symbol) : std::nullopt;
}

using Pair = std::pair<SymbolId, SymbolId>;

std::optional<Pair> product_of_two(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::multiply || tree.children(id).size() != 2) return std::nullopt;
  const auto first = bare_operator(tree, tree.children(id)[0]);
  const auto second = bare_operator(tree, tree.children(id)[1]);
  return first && second ? std::optional(Pair(*first, *second)) : std::nullopt;
}

/// `AB - BA`
std::optional<Pair> commutator_of_two(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::add || tree.children(id).size() != 2) return std::nullopt;
  const ExprId second = tree.children(id)[1];
  if (tree[second].op != Op::negate) return std::nullopt;
  const auto there = product_of_two(tree, tree.children(id)[0]);
  const auto back = product_of_two(tree, tree.children(second)[0]);
  const bool turned = there && back && there->first == back->second && there->second == back->first;
  return turned && there->first != there->second ? there : std::nullopt;
}

/// `i\hbar`, `-i\hbar L_z`: i as a factor, once.
bool is_imaginary_multiple(const ExprTree& tree, ExprId id) {
  const std::span<const ExprId> children = tree.children(id);
  switch (tree[id].op) {
    case Op::imaginary_unit:
      return true;
    case Op::negate:
      return is_imaginary_multiple(tree, children[0]);
    case Op::divide:
      return is_imaginary_multiple(tree, children[0]);
    case Op::multiply:
      return std::ranges::count_if(children,
                                   [&](ExprId each) { return is_imaginary_multiple(tree, each); }) == 1;
    default:
      return false;
  }
}

}  // namespace

std::set<SymbolId> observables_of(const ExprTree& tree, const Laws& laws) {
  std::set<SymbolId> found;
  for (const PageLaw* law : laws) {
    const auto pair = commutator_of_two(tree, law->equation.left);
    // [K, S] = iS says nothing of S, and i times a complex number nothing of either.
    const std::vector<SymbolId> letters = symbols_in(tree, law->equation.right);
    const bool number = std::ranges::none_of(letters, [&](SymbolId each) {
      return tree.symbols[each].noncommuting || tree.symbols[each].complex;
    });
    if (pair && number && is_imaginary_multiple(tree, law->equation.right))
      found.insert({pair->first, pair->second});
  }
  return found;
}

bool writes_adjoints(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  return std::ranges::any_of(nodes_reached(tree, scope, {equation.left, equation.right}), [&](ExprId id) {
    return tree[id].op == Op::conjugate && has_operators(tree, id);
  });
}

PageLaw self_adjoint_law(ExprTree& tree, SymbolId letter, Span span, std::string name) {
  const std::array letters{tree.add({.op = Op::symbol, .span = span, .symbol = letter})};
  Equation equation;
  equation.left = tree.add({.op = Op::conjugate, .span = span}, letters);
  equation.right = letters[0];
  return {.equation = std::move(equation), .name = std::move(name), .span = span, .by_convention = true};
}

}  // namespace rigor
