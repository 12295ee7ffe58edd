// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/shape.h"

#include <algorithm>
#include <set>
#include <vector>

namespace rigor {
namespace {

/// Recursion: as deep as the tree.
class Shape {
 public:
  explicit Shape(const ExprTree& tree) : tree_(tree) {}

  std::string write(ExprId id) {
    const ExprNode& node = tree_[id];
    if (node.op == Op::index_sum) {
      const bool outer = !summed_.insert(node.index).second;
      std::string body = write(tree_.children(id)[0]);
      if (!outer) summed_.erase(node.index);
      return body;
    }
    if (node.op == Op::particle_sum) {
      const bool outer = !particles_.insert(node.particle).second;
      std::string body = "sum(" + write(tree_.children(id)[0]) + ')';
      if (!outer) particles_.erase(node.particle);
      return body;
    }
    std::vector<std::string> parts;
    collect(id, node.op, parts);
    if (node.op == Op::add || node.op == Op::multiply || node.op == Op::dot) std::ranges::sort(parts);
    std::string text = head(id) + '(';
    for (const std::string& part : parts) text += part + ',';
    return text + ')';
  }

 private:
  /// Sums in sums and products in products are one.
  void collect(ExprId id, Op op, std::vector<std::string>& parts) {
    for (const ExprId child : tree_.children(id)) {
      ExprId inner = child;
      std::vector<IndexId> opened;
      while (op == Op::multiply &&
             tree_[inner].op == Op::index_sum) {  // sums in a product are in front of it
        if (summed_.insert(tree_[inner].index).second) opened.push_back(tree_[inner].index);
        inner = tree_.children(inner)[0];
      }
      const bool joins = (op == Op::add || op == Op::multiply) && tree_[inner].op == op;
      if (joins) {
        collect(inner, op, parts);
      } else {
        parts.push_back(write(inner));
      }
      for (const IndexId index : opened) summed_.erase(index);
    }
  }

  std::string head(ExprId id) const {
    const ExprNode& node = tree_[id];
    std::string text = std::to_string(static_cast<int>(node.op));
    if (node.op == Op::number) text += '#' + tree_.digits(id);
    if (node.op == Op::symbol) text += 's' + std::to_string(static_cast<std::uint32_t>(node.symbol));
    if (node.op == Op::power) text += '^' + std::to_string(node.exponent);
    if (node.op == Op::function) text += 'f' + std::to_string(static_cast<int>(node.function));
    if (node.particle != no_particle) {
      const bool bound = particles_.contains(node.particle);
      text += bound ? "{*}" : '{' + std::to_string(static_cast<std::uint32_t>(node.particle)) + '}';
    }
    for (const Slot& slot : tree_.slots(id)) text += name_of(slot);
    return text;
  }

  std::string name_of(const Slot& slot) const {
    if (slot.axis != 0) return '[' + std::to_string(slot.axis) + ']';
    if (summed_.contains(slot.variable)) return "[*]";
    return "[f" + std::to_string(static_cast<std::uint32_t>(slot.variable)) + ']';
  }

  const ExprTree& tree_;
  std::set<IndexId> summed_;
  std::set<ParticleId> particles_;
};

}  // namespace

std::string shape_of(const ExprTree& tree, ExprId root) { return Shape(tree).write(root); }

}  // namespace rigor
