// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/unfold.h"

#include <algorithm>
#include <functional>

#include "derive/notation/letter_choice.h"
#include "derive/polynomial/nodes.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// A copy in which each node went through `change`. Recursion: as deep as the tree.
ExprId rebuilt(ExprTree& tree, ExprId root,
               const std::function<void(ExprNode&, std::vector<Slot>&)>& change) {
  ExprNode node = tree[root];
  const std::vector<ExprId> before(tree.children(root).begin(), tree.children(root).end());
  std::vector<ExprId> after;
  for (const ExprId child : before) after.push_back(rebuilt(tree, child, change));
  std::vector<Slot> slots(tree.slots(root).begin(), tree.slots(root).end());
  change(node, slots);
  if (node.op == Op::number) return root;
  return with_children(tree, root, node, after, slots);
}

/// (√x)² as x.
ExprId without_squared_roots(ExprTree& tree, ExprId root) {
  ExprNode node = tree[root];
  const std::vector<ExprId> before(tree.children(root).begin(), tree.children(root).end());
  if (node.op == Op::power && node.exponent % 2 == 0 && tree[before[0]].op == Op::root) {
    const ExprId argument = without_squared_roots(tree, tree.children(before[0])[0]);
    return power_node(tree, argument, node.exponent / 2);
  }
  std::vector<ExprId> after;
  for (const ExprId child : before) after.push_back(without_squared_roots(tree, child));
  if (after == before) return root;
  const std::vector<Slot> slots(tree.slots(root).begin(), tree.slots(root).end());
  return with_children(tree, root, node, after, slots);
}

}  // namespace

ExprId component_within(ExprTree& tree, ExprId id, const std::vector<Slot>& slots) {
  if (slots.empty() || tree[id].rank == 0) return id;
  ExprNode node = tree[id];
  std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  switch (node.op) {
    case Op::add:
    case Op::negate:
    case Op::index_sum:
    case Op::particle_sum:
    case Op::divide:
    case Op::multiply:
      break;
    default:
      return component_of(tree, id, slots);
  }
  for (const ExprId child : children) {
    const auto rank = static_cast<std::size_t>(tree[child].rank);
    if (rank != 0 && rank != slots.size()) return component_of(tree, id, slots);  // a dyad
  }
  for (ExprId& child : children) child = component_within(tree, child, slots);
  node.rank = 0;
  return tree.add(node, children);
}

ExprId with_slots(ExprTree& tree, ExprId root, const std::vector<IndexId>& variables,
                  const std::vector<Slot>& by) {
  if (variables.empty()) return root;
  return rebuilt(tree, root, [&](ExprNode&, std::vector<Slot>& slots) {
    for (Slot& slot : slots) {
      const auto place = std::ranges::find(variables, slot.variable);
      if (slot.axis == 0 && place != variables.end())
        slot = by[static_cast<std::size_t>(place - variables.begin())];
    }
  });
}

ExprId with_particle(ExprTree& tree, ExprId root, ParticleId variable, ParticleId by) {
  if (variable == no_particle || variable == by) return root;
  return rebuilt(tree, root, [&](ExprNode& node, std::vector<Slot>&) {
    if (node.particle == variable) node.particle = by;
  });
}

ExprId unfolded(ExprTree& tree, ExprId root, const Definition& definition) {
  const ExprId result = replaced(tree, root, [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree[id];
    if (node.symbol != definition.symbol) return std::nullopt;
    const std::vector<Slot> slots(tree.slots(id).begin(), tree.slots(id).end());
    if (slots.size() < definition.indices.size()) return std::nullopt;
    ExprId body = with_letters(tree, definition.body, {});  // sums of its own
    if (node.particle != no_particle) body = with_particle(tree, body, definition.particle, node.particle);
    if (!definition.indices.empty()) return with_slots(tree, body, definition.indices, slots);
    return component_within(tree, body, slots);
  });
  return result == root ? root : without_squared_roots(tree, result);
}

}  // namespace rigor
