// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/one_direction.h"

#include <map>
#include <set>

#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// What one side has of vectors.
struct SideOfVectors {
  std::set<SymbolId> plain;  // of their lengths, written as plain letters
  bool odd = false;          // one of them in an odd power
  bool others = false;       // a vector, a component, bars
  bool indices = false;      // sums over indices, as derivatives by coordinates bring in
};

bool is_plain_length(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::length) return false;
  const ExprNode& vector = tree[tree.children(id)[0]];
  return vector.op == Op::symbol && vector.span == tree[id].span;
}

class Looking {
 public:
  explicit Looking(const ExprTree& tree) : tree_(tree) {}

  SideOfVectors look(ExprId side) {
    visit(side, true);
    return std::move(found_);
  }

 private:
  /// `odd`: as a factor of what is in an odd power.
  void visit(ExprId id, bool odd) {
    const ExprNode& node = tree_[id];
    if (is_plain_length(tree_, id)) {
      found_.plain.insert(tree_[tree_.children(id)[0]].symbol);
      found_.odd = found_.odd || odd;
      return;
    }
    switch (node.op) {
      case Op::index_sum:
      case Op::basis:
      case Op::delta:
      case Op::epsilon:
      case Op::table:
        found_.indices = true;
        break;
      case Op::length:
      case Op::component:
        found_.others = true;
        break;
      default:
        found_.others = found_.others || node.rank > 0 || node.slot_count > 0;
    }
    const bool factors = node.op == Op::multiply || node.op == Op::divide || node.op == Op::negate;
    const bool even = node.op == Op::power && node.exponent % 2 == 0;
    for (const ExprId child : tree_.children(id)) visit(child, even ? false : (factors ? odd : true));
  }

  const ExprTree& tree_;
  SideOfVectors found_;
};

}  // namespace

std::vector<SymbolId> lengths_or_components(const ExprTree& tree, const Equation& equation) {
  const SideOfVectors left = Looking(tree).look(equation.left);
  const SideOfVectors right = Looking(tree).look(equation.right);
  const auto is_of_plain_letters = [](const SideOfVectors& side) { return side.odd && !side.others; };
  if (left.indices || right.indices || (!is_of_plain_letters(left) && !is_of_plain_letters(right))) return {};
  std::set<SymbolId> vectors = left.plain;
  vectors.insert(right.plain.begin(), right.plain.end());
  return {vectors.begin(), vectors.end()};
}

std::optional<Equation> with_numbers_for_lengths(ExprTree& tree, const Equation& equation) {
  if (Looking(tree).look(equation.left).others || Looking(tree).look(equation.right).others)
    return std::nullopt;
  std::map<SymbolId, SymbolId> numbers;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode vector = tree[id];
    if (vector.rank != 1) return std::nullopt;
    const auto [entry, fresh] = numbers.try_emplace(vector.symbol);
    if (fresh) {
      Symbol number{.name = tree.symbols[vector.symbol].name};
      number.per_particle = tree.symbols[vector.symbol].per_particle;
      entry->second = tree.symbols.add(std::move(number));
    }
    const ExprNode number{
        .op = Op::symbol, .span = vector.span, .symbol = entry->second, .particle = vector.particle};
    const Space space = vector.axes[0];
    std::vector<ExprId> along(space.dimension, tree.add_number(vector.span, "0"));
    along[0] = tree.add(number);
    return tree.add({.op = Op::tuple, .rank = 1, .span = vector.span, .axes = AxisSpaces::of(space, 1)},
                    along);
  };
  Equation numeric = equation;
  numeric.left = replaced(tree, equation.left, by);
  numeric.right = replaced(tree, equation.right, by);
  return numeric;
}

bool may_be_in_the_plane(const ExprTree& tree, const Evidence& evidence, const Equation& equation) {
  if (evidence.third_axis) return false;
  std::array<bool, 4> along{};
  for (const ExprId id : nodes_below(tree, {equation.left, equation.right})) {
    const ExprNode& node = tree[id];
    const AxisSpaces axes = node.op == Op::component ? tree[tree.children(id)[0]].axes
                            : node.op == Op::symbol  ? tree.symbols[node.symbol].axes
                                                     : node.axes;
    const std::span<const Slot> slots = tree.slots(id);
    for (std::size_t k = 0; k < slots.size(); ++k) {
      if (axes[static_cast<int>(k)] == common_space) along.at(slots[k].axis) = true;
    }
  }
  return along[1] && along[2] && !along[3];
}

}  // namespace rigor
