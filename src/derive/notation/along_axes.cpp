// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/along_axes.h"

#include <map>
#include <vector>

#include "derive/notation/in_components.h"
#include "derive/notation/unfold.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

constexpr std::size_t most_nodes = 6000;

/// Thrown where there are too many nodes, or a free letter that was not given; caught by `along_axes`.
struct CannotBeWritten {};

/// Nothing stands for 0. Recursion: as deep as the tree.
class AlongAxes {
 public:
  AlongAxes(ExprTree& tree, std::map<IndexId, std::uint8_t> axes) : tree_(tree), axes_(std::move(axes)) {}

  std::optional<ExprId> write(ExprId id) {
    if (++nodes_ > most_nodes) throw CannotBeWritten{};
    const ExprNode node = tree_[id];
    switch (node.op) {
      case Op::number:
        return tree_.is_zero_literal(id) ? std::nullopt : std::optional(id);
      case Op::delta:
      case Op::epsilon:
        return sign(id);
      case Op::index_sum:
        return sum(id);
      case Op::add:
        return terms(id);
      case Op::multiply:
        return product(id);
      case Op::component:
        return component(id);
      case Op::table:
        return table(id);
      default:
        return other(id);
    }
  }

 private:
  Slot bound(const Slot& slot) const {
    if (slot.axis != 0) return slot;
    const auto known = axes_.find(slot.variable);
    return known == axes_.end() ? slot : Slot{.axis = known->second};
  }

  std::vector<Slot> bound_slots(ExprId id) const {
    std::vector<Slot> slots;
    for (const Slot& slot : tree_.slots(id)) slots.push_back(bound(slot));
    return slots;
  }

  ExprId at_axes(ExprId id) {
    std::vector<IndexId> variables;
    std::vector<Slot> slots;
    for (const auto& [variable, axis] : axes_) {
      variables.push_back(variable);
      slots.push_back({.axis = axis});
    }
    return with_slots(tree_, id, variables, slots);
  }

  std::vector<ExprId> children(ExprId id) const {
    return {tree_.children(id).begin(), tree_.children(id).end()};
  }

  std::optional<ExprId> sign(ExprId id) {
    const std::vector<Slot> slots = bound_slots(id);
    for (const Slot& slot : slots) {
      if (slot.axis == 0) throw CannotBeWritten{};  // a letter that was not given
    }
    int value = slots[0].axis == slots[1].axis ? 1 : 0;
    if (slots.size() == 3) {
      value = (slots[0].axis - slots[1].axis) * (slots[1].axis - slots[2].axis) *
              (slots[2].axis - slots[0].axis) / 2;
    }
    if (value == 0) return std::nullopt;
    return number_node(tree_, value);
  }

  std::optional<ExprId> sum(ExprId id) {
    const IndexId index = tree_[id].index;
    const ExprId body = children(id)[0];
    std::vector<ExprId> all;
    const auto outer = axes_;
    for (std::uint8_t axis = 1; axis <= 3; ++axis) {
      axes_[index] = axis;
      if (const auto term = write(body)) append(all, *term);
    }
    axes_ = outer;
    return all.empty() ? std::nullopt : std::optional(sum_node(tree_, all));
  }

  void append(std::vector<ExprId>& all, ExprId term) {
    if (tree_[term].op != Op::add) {
      all.push_back(term);
      return;
    }
    const auto parts = children(term);
    all.insert(all.end(), parts.begin(), parts.end());
  }

  std::optional<ExprId> terms(ExprId id) {
    std::vector<ExprId> all;
    for (const ExprId child : children(id)) {
      if (const auto term = write(child)) append(all, *term);
    }
    return all.empty() ? std::nullopt : std::optional(sum_node(tree_, all));
  }

  std::optional<ExprId> product(ExprId id) {
    std::vector<ExprId> factors;
    bool negative = false;
    for (const ExprId child : children(id)) {
      auto factor = write(child);
      if (!factor) return std::nullopt;
      if (tree_[*factor].op == Op::negate) {
        negative = !negative;
        factor = children(*factor)[0];
      }
      factors.push_back(*factor);
    }
    const ExprId all = product_node(tree_, factors);
    return negative ? negated_node(tree_, all) : all;
  }

  std::optional<ExprId> component(ExprId id) {
    WrittenOut what;
    const ExprId inner = in_components(tree_, children(id)[0], bound_slots(id), what);
    if (tree_[inner].op == Op::component) throw CannotBeWritten{};
    return write(inner);
  }

  std::optional<ExprId> table(ExprId id) {
    std::size_t place = 0;
    for (const Slot& slot : bound_slots(id)) {
      if (slot.axis == 0) throw CannotBeWritten{};
      place = 3 * place + slot.axis - 1u;
    }
    return write(children(id)[tree_.table(id).entry[place]]);
  }

  std::optional<ExprId> other(ExprId id) {
    ExprNode node = tree_[id];
    const std::vector<ExprId> before = children(id);
    std::vector<ExprId> after;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const bool whole = tree_[before[k]].rank > 0;  // |a| of a vector stays
      const auto child = whole ? std::optional(at_axes(before[k])) : write(before[k]);
      const bool vanishes =
          !child && (node.op == Op::negate || node.op == Op::particle_sum || node.op == Op::root ||
                     node.op == Op::absolute || (node.op == Op::divide && k == 0) ||
                     (node.op == Op::power && node.exponent > 0));
      if (vanishes) return std::nullopt;
      after.push_back(child ? *child : number_node(tree_, 0));
    }
    if (node.op == Op::negate && tree_[after[0]].op == Op::negate) return children(after[0])[0];
    return tree_.add(node, after, bound_slots(id));
  }

  ExprTree& tree_;
  std::map<IndexId, std::uint8_t> axes_;
  std::size_t nodes_ = 0;
};

}  // namespace

std::optional<ExprId> along_axes(ExprTree& tree, ExprId id, std::span<const IndexId> variables,
                                 std::span<const std::uint8_t> axes) {
  std::map<IndexId, std::uint8_t> bound;
  for (std::size_t k = 0; k < variables.size(); ++k) bound[variables[k]] = axes[k];
  std::vector<Slot> slots;
  for (std::size_t k = variables.size(); k < axes.size(); ++k) slots.push_back({.axis = axes[k]});
  WrittenOut what;
  const ExprId components = in_components(tree, id, slots, what);
  try {
    const auto written = AlongAxes(tree, std::move(bound)).write(components);
    return written ? *written : number_node(tree, 0);
  } catch (const CannotBeWritten&) {
    return std::nullopt;
  }
}

}  // namespace rigor
