// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/definition.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

/// `(\Omega_1)^2 = …` says what a number is by its square; of the two, it is the one that is not negative.
std::optional<Definition> as_square(ExprTree& tree, const NameScope& scope, const Typed& left,
                                    const Typed& right) {
  Typed base = left;
  base.id = tree.children(left.id)[0];
  const bool plain = tree[base.id].op == Op::symbol && tree.slots(base.id).empty() &&
                     tree[base.id].particle == no_particle && right.free.empty() && right.particles.empty();
  if (!plain || right.rank != 0 || is_circular(tree, scope, base, right)) return std::nullopt;
  Definition definition;
  definition.symbol = tree[base.id].symbol;
  definition.body = tree.add({.op = Op::root, .span = tree[right.id].span}, std::span(&right.id, 1));
  definition.by_square = true;
  return definition;
}

}  // namespace

int derivative_order(const SymbolTable& symbols, SymbolId symbol) {
  return symbols[symbol].order(By::time) + symbols[symbol].order(By::space);
}

namespace {

/// The signs before a symbol of space-time whose indices are lowered, from the outside; none before others.
std::vector<ExprId> signs_before(const ExprTree& tree, ExprId& id) {
  std::vector<ExprId> signs;
  while (tree[id].op == Op::multiply && tree[id].count == 2) {
    const ExprId sign = tree.children(id)[0];
    const bool of_index = tree[sign].op == Op::table && tree[sign].slot_count == 1 &&
                          tree.slots(sign)[0].axis == 0 &&
                          tree.space(tree.slots(sign)[0].variable) == space_time;
    if (!of_index) break;
    signs.push_back(sign);
    id = tree.children(id)[1];
  }
  if (tree[id].op != Op::symbol) signs.clear();
  return signs;
}

}  // namespace

std::optional<Definition> as_definition(ExprTree& tree, const NameScope& scope, const Typed& left,
                                        const Typed& right) {
  Typed raised = left;
  if (const std::vector<ExprId> signs = signs_before(tree, raised.id); !signs.empty()) {
    Typed value = right;  // the signs are their own inverses
    for (const ExprId sign : signs) {
      const std::array<ExprId, 2> factors{sign, value.id};
      value.id = tree.add({.op = Op::multiply, .span = tree[right.id].span}, factors);
    }
    return as_definition(tree, scope, raised, value);
  }
  const ExprNode node = tree[left.id];
  if (node.op == Op::power && node.exponent == 2) return as_square(tree, scope, left, right);
  const bool alike = left.rank == right.rank && node.axes == tree[right.id].axes;
  if (node.op != Op::symbol || !alike) return std::nullopt;
  Definition definition;
  definition.symbol = node.symbol;
  definition.particle = node.particle;
  definition.body = right.id;
  for (const Slot& slot : tree.slots(left.id)) {
    const bool repeated =
        std::ranges::any_of(definition.indices, [&](IndexId id) { return id == slot.variable; });
    if (slot.axis != 0 || repeated) return std::nullopt;
    definition.indices.push_back(slot.variable);
  }
  const bool letters_fit = std::ranges::all_of(
      right.free, [&](const FreeIndex& free) { return is_one_of(free.id, definition.indices); });
  const bool particles_fit = std::ranges::all_of(
      right.particles, [&](const FreeParticle& free) { return free.id == definition.particle; });
  const bool all_bound = left.free.size() == definition.indices.size() &&
                         left.particles.size() == (node.particle == no_particle ? 0u : 1u);
  if (!letters_fit || !particles_fit || !all_bound) return std::nullopt;
  if (!is_literal_zero(tree, right) && right.free.size() != definition.indices.size()) return std::nullopt;
  return is_circular(tree, scope, left, right) ? std::nullopt : std::optional(definition);
}

bool is_circular(const ExprTree& tree, const NameScope& scope, const Typed& left, const Typed& right) {
  if (tree[left.id].op != Op::symbol) return false;
  const SymbolId own = tree[left.id].symbol;
  const bool is_newer = static_cast<std::size_t>(scope.last_body) < tree.symbols[own].made_at;
  const auto body_of = [&](SymbolId symbol) {  // no definition can have what came after all of them
    return is_newer ? std::nullopt : body_of_definition(scope, symbol);
  };
  std::set<SymbolId> seen;
  std::vector<ExprId> pending{right.id};
  while (!pending.empty()) {
    for (const SymbolId symbol : symbols_reached(tree, std::exchange(pending, {}), body_of)) {
      if (symbol == own) return true;
      const auto& integral = tree.symbols[base_of(tree.symbols, symbol)].integral;
      if (!integral || !seen.insert(symbol).second) continue;
      for (const ExprId part : parts_of(*integral)) pending.push_back(part);
    }
  }
  return false;
}

bool stands_in_brackets(const SyntaxTree& syntax, SyntaxId power) {
  return syntax[power].kind == SyntaxKind::power && syntax[syntax.child(power, 0)].kind == SyntaxKind::group;
}

bool is_determined(const SymbolTable& symbols, const NameScope& scope, SymbolId symbol) {
  return std::ranges::any_of(scope.definitions, [&](const NamedDefinition& entry) {
    const SymbolId known = entry.definition.symbol;
    return base_of(symbols, known) == base_of(symbols, symbol) &&
           derivative_order(symbols, known) <= derivative_order(symbols, symbol);
  });
}

bool is_rule(ExprTree& tree, const NameScope& scope, const Typed& left, const Typed& right) {
  const auto definition = as_definition(tree, scope, left, right);
  if (!definition || tree[left.id].op != Op::symbol) return false;
  return tree.symbols[definition->symbol].derivation &&
         !is_determined(tree.symbols, scope, definition->symbol);
}

bool would_define(ExprTree& tree, const NameScope& scope, const Typed& left, const Typed& right) {
  const auto definition = as_definition(tree, scope, left, right);
  if (!definition) return false;
  const bool rate = tree.symbols[definition->symbol].derivation.has_value();
  return !rate && definition_of(scope, definition->symbol) == nullptr &&
         !seen_in_equation(scope, definition->symbol);
}

}  // namespace rigor
