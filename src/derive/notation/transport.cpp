// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/transport.h"

#include <array>
#include <optional>

#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

std::vector<ExprId> children_of(const ExprTree& tree, ExprId id) {
  return {tree.children(id).begin(), tree.children(id).end()};
}

/// x of `R_ij x`.
std::optional<ExprId> beside_rotation(const ExprTree& tree, ExprId product, SymbolId rotation) {
  if (tree[product].op != Op::multiply || tree[product].count != 2) return std::nullopt;
  const ExprId first = tree.children(product)[0];
  const bool fits = tree[first].op == Op::symbol && tree[first].symbol == rotation;
  return fits ? std::optional(tree.children(product)[1]) : std::nullopt;
}

/// The vector whose component 1, 2 or 3 an expression is.
std::optional<ExprId> vector_of(ExprTree& tree, ExprId component, std::uint8_t axis) {
  const auto slots = tree.slots(component);
  if (slots.size() != 1 || slots[0].axis != axis) return std::nullopt;
  const ExprNode node = tree[component];
  if (node.op == Op::component) return tree.children(component)[0];
  if (node.op == Op::symbol) return symbol_node(tree, node.symbol, node.particle, {});
  return std::nullopt;
}

/// ω of the first row of Ṙ: (R_12 ω_3 − R_13 ω_2, R_13 ω_1 − …, …).
std::optional<ExprId> angular_velocity(ExprTree& tree, ExprId rate, SymbolId rotation) {
  if (tree[rate].op != Op::tuple || tree[rate].rank != 2) return std::nullopt;
  const auto row = children_of(tree, tree.children(rate)[0]);
  std::array<ExprId, 3> components{};
  for (std::size_t column = 0; column < 2; ++column) {
    if (row.size() != 3 || tree[row[column]].op != Op::add || tree[row[column]].count != 2)
      return std::nullopt;
    const auto terms = children_of(tree, row[column]);
    const auto first = beside_rotation(tree, terms[0], rotation);
    if (!first || tree[terms[1]].op != Op::negate) return std::nullopt;
    const auto second = beside_rotation(tree, tree.children(terms[1])[0], rotation);
    if (!second) return std::nullopt;
    components[(column + 2) % 3] = *first;
    components[(column + 1) % 3] = *second;
  }
  const auto whole = vector_of(tree, components[2], 3);
  if (whole && vector_of(tree, components[0], 1) && vector_of(tree, components[1], 2)) return whole;
  return tree.add({.op = Op::tuple, .rank = 1}, components);
}

bool is_symbol(const ExprTree& tree, ExprId id, SymbolId symbol) {
  return tree[id].op == Op::symbol && tree[id].symbol == symbol && tree[id].slot_count == 0;
}

/// A of `S·A`.
std::optional<ExprId> applied_to(const ExprTree& tree, ExprId id, SymbolId tensor) {
  if (tree[id].op != Op::dot || !is_symbol(tree, tree.children(id)[0], tensor)) return std::nullopt;
  return tree.children(id)[1];
}

/// Ȧ + ω×A of (ṘA + RȦ)·R.
std::optional<ExprId> seen_from_frame(ExprTree& tree, ExprId id, const TurningFrame& frame) {
  if (tree[id].op != Op::dot || !is_symbol(tree, tree.children(id)[1], frame.rotation)) return std::nullopt;
  const ExprId rate = tree.children(id)[0];
  const std::vector<ExprId> terms =
      tree[rate].op == Op::add ? children_of(tree, rate) : std::vector<ExprId>{rate};
  std::vector<ExprId> result;
  for (const ExprId term : terms) {
    if (const auto turned = applied_to(tree, term, frame.rate)) {
      result.push_back(cross_node(tree, frame.angular_velocity, *turned));
    } else if (const auto changed = applied_to(tree, term, frame.rotation)) {
      result.insert(result.begin(), *changed);
    } else {
      return std::nullopt;
    }
  }
  return sum_node(tree, result, 1);
}

}  // namespace

std::vector<TurningFrame> turning_frames(ExprTree& tree, const Question& question) {
  std::vector<TurningFrame> frames;
  for (const Definition& definition : question.definitions) {
    const auto& derivation = tree.symbols[definition.symbol].derivation;
    if (!derivation || derivation->by != Derivation::Variables{By::time}) continue;
    const SymbolId rotation = derivation->base;
    if (const auto velocity = angular_velocity(tree, definition.body, rotation))
      frames.push_back({rotation, definition.symbol, *velocity});
  }
  return frames;
}

ExprId transported(ExprTree& tree, ExprId root, const TurningFrame& frame) {
  const std::vector<ExprId> before = children_of(tree, root);
  std::vector<ExprId> after;
  for (const ExprId child : before) after.push_back(transported(tree, child, frame));
  ExprId result = root;
  if (after != before) {
    const ExprNode node = tree[root];
    const std::vector<Slot> slots(tree.slots(root).begin(), tree.slots(root).end());
    result = with_children(tree, root, node, after, slots);
  }
  return seen_from_frame(tree, result, frame).value_or(result);
}

}  // namespace rigor
