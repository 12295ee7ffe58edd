// SPDX-License-Identifier: GPL-3.0-or-later
// Components that are written as a whole: ∇, rates in a fixed frame, primed axes, determinants of a tensor.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "expr/print/latex_printer.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

constexpr std::array<std::uint8_t, 3> all_axes{1, 2, 3};

}  // namespace

std::optional<LatexPrinter::Piece> LatexPrinter::field(ExprId id) {
  const Op op = tree_[id].op;
  if (op != Op::tuple && op != Op::add && op != Op::dot) return std::nullopt;
  if (op == Op::dot) return turned(id);
  if (auto basis = primed_basis(id)) return basis;
  return tree_.children(id).size() == 3 ? nabla(id) : std::nullopt;
}

/// The symbol at literal axes, if it is a derivative by coordinates of at least this order.
const ExprNode* LatexPrinter::derivative_symbol(ExprId id, int orders) const {
  while (tree_[id].op == Op::tuple || tree_[id].op == Op::negate) id = child(id);
  const ExprNode& node = tree_[id];
  if (node.op != Op::symbol || node.slot_count == 0) return nullptr;
  return tree_.symbols[node.symbol].order(By::space) == orders ? &node : nullptr;
}

bool LatexPrinter::has_axes(ExprId id, SymbolId symbol, const std::vector<std::uint8_t>& axes) const {
  const ExprNode& node = tree_[id];
  const auto slots = tree_.slots(id);
  if (node.op != Op::symbol || node.symbol != symbol || slots.size() != axes.size()) return false;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (slots[k].axis != axes[k]) return false;
  }
  return true;
}

/// Is it the symbol at `axes`, then all axes of the missing ones, then `behind`?
bool LatexPrinter::is_whole_at(ExprId id, SymbolId symbol, int missing, std::vector<std::uint8_t>& axes,
                               const std::vector<std::uint8_t>& behind) const {
  if (missing == 0) {
    std::vector<std::uint8_t> all = axes;
    all.insert(all.end(), behind.begin(), behind.end());
    return has_axes(id, symbol, all);
  }
  if (tree_[id].op != Op::tuple || tree_[id].count != all_axes.size()) return false;
  for (const std::uint8_t axis : all_axes) {
    axes.push_back(axis);
    const bool same = is_whole_at(child(id, axis - 1u), symbol, missing - 1, axes, behind);
    axes.pop_back();
    if (!same) return false;
  }
  return true;
}

/// ∇f, ∇·A, ∇×A, ∇²A and (A·∇)B of one symbol, from their three components or terms.
std::optional<LatexPrinter::Piece> LatexPrinter::nabla(ExprId id) {
  const bool sum = tree_[id].op == Op::add;
  const ExprId first = child(id);
  const bool along = sum && tree_[first].op == Op::multiply && tree_.children(first).size() == 2;
  const bool curl = !sum && tree_[first].op == Op::add;
  const int orders = derivative_symbol(first, 2) != nullptr ? 2 : 1;
  const ExprNode* node = derivative_symbol(along ? child(first, 1) : curl ? child(first) : first, orders);
  if (node == nullptr) return std::nullopt;
  const SymbolId symbol = node->symbol;
  const Derivation& derivation = *tree_.symbols[symbol].derivation;
  const Symbol& base = tree_.symbols[derivation.base];
  std::vector<std::uint8_t> axes;
  std::string sign = "\\nabla";
  for (const std::uint8_t i : all_axes) {
    const auto j = static_cast<std::uint8_t>(i % 3 + 1);
    const auto k = static_cast<std::uint8_t>(j % 3 + 1);
    const ExprId each = child(id, i - 1u);
    if (curl) {
      const bool both = base.rank == 1 && tree_[each].op == Op::add && tree_.children(each).size() == 2 &&
                        tree_[child(each, 1)].op == Op::negate;
      if (!both || !has_axes(child(each), symbol, {k, j}) || !has_axes(child(child(each, 1)), symbol, {j, k}))
        return std::nullopt;
      sign = "\\nabla\\times";
    } else if (along) {
      if (tree_[each].op != Op::multiply || tree_.children(each).size() != 2) return std::nullopt;
      const ExprNode& direction = tree_[child(each)];
      const ExprNode& start = tree_[child(first)];
      const bool straight = direction.op == Op::symbol && direction.symbol == start.symbol &&
                            start.op == Op::symbol && tree_.symbols[start.symbol].rank == 1 &&
                            direction.particle == start.particle &&
                            has_axes(child(each), direction.symbol, {i});
      if (!straight || orders != 1 || !is_whole_at(child(each, 1), symbol, base.rank, axes, {i}))
        return std::nullopt;
      ExprNode whole = direction;
      whole.slot_count = 0;
      const Symbol& of = tree_.symbols[direction.symbol];
      const int dots = of.order(By::time);
      if (of.order() > dots || (dots > 0 && notation_.frame)) return std::nullopt;
      const SymbolId letter = base_of(tree_.symbols, direction.symbol);
      sign = "(" + plain_symbol(letter, whole, {}, dots).text + "\\cdot\\nabla)\\,";
    } else if (sum && orders == 1) {
      if (base.rank != 1 || !has_axes(each, symbol, {i, i})) return std::nullopt;
      sign = "\\nabla\\cdot";
    } else if (!is_whole_at(each, symbol, base.rank, axes,
                            sum ? std::vector<std::uint8_t>{i, i} : std::vector<std::uint8_t>{i})) {
      return std::nullopt;
    } else {
      if (sum != (orders == 2) || (!sum && orders != 1)) return std::nullopt;
      if (sum) sign = "\\nabla^2";
    }
  }
  if (derivation.by.size() > derivation.by.count(By::space)) return std::nullopt;
  const Piece operand = plain_symbol(derivation.base, *node, {}, 0);
  if (operand.text.front() != '\\' && !sign.ends_with(',')) sign += ' ';
  append_latex(sign, operand.text);
  return Piece{sign, Level::term, true};
}

/// Is the one what differentiating the other by the time gives?
bool LatexPrinter::is_rate(ExprId rate, ExprId of) const {
  const ExprNode& node = tree_[of];
  if (node.op == Op::symbol) {
    const ExprNode& its = tree_[rate];
    if (its.op != Op::symbol || node.slot_count > 0 || its.slot_count > 0 || its.particle != node.particle)
      return false;
    Derivation derivation = tree_.symbols[node.symbol].derivation.value_or(Derivation{.base = node.symbol});
    derivation.by.insert(By::time);
    return tree_.symbols.find(derivation) == its.symbol;
  }
  if (tree_[rate].op != Op::add) return false;
  const auto terms = tree_.children(rate);
  if (terms.size() != 2 || tree_.children(of).size() != 2) return false;
  if (node.op == Op::add) return is_rate(terms[0], child(of, 0)) && is_rate(terms[1], child(of, 1));
  if (node.op != Op::dot || tree_[terms[0]].op != Op::dot || tree_[terms[1]].op != Op::dot) return false;
  return is_rate(child(terms[0], 0), child(of, 0)) &&
         same_expression(tree_, child(terms[0], 1), tree_, child(of, 1)) &&
         same_expression(tree_, child(terms[1], 0), tree_, child(of, 0)) &&
         is_rate(child(terms[1], 1), child(of, 1));
}

/// A rate in the fixed frame is that of components along fixed axes, carried back: (dA/dt)_in = Rᵀ d(R A)/dt.
std::optional<LatexPrinter::Piece> LatexPrinter::turned(ExprId id) {
  if (!notation_.frame || tree_[id].rank != 1) return std::nullopt;
  const SymbolId rotation = notation_.frame->rotation;
  int times = 0;
  ExprId vector = id;
  while (tree_[vector].op == Op::dot) {
    const ExprNode& back = tree_[child(vector, 1)];
    const ExprId change = child(vector, 0);
    if (back.op != Op::symbol || back.symbol != rotation || tree_[change].op != Op::add) break;
    const auto terms = tree_.children(change);
    if (terms.size() != 2 || tree_[terms[0]].op != Op::dot || tree_[terms[1]].op != Op::dot)
      return std::nullopt;
    const ExprId inner = child(terms[0], 1);
    const ExprNode& carried = tree_[child(terms[1], 0)];
    const bool turns = is_rate(child(terms[0], 0), child(vector, 1)) && carried.op == Op::symbol &&
                       carried.symbol == rotation && is_rate(child(terms[1], 1), inner);
    if (!turns) return std::nullopt;
    vector = inner;
    ++times;
  }
  const ExprNode& node = tree_[vector];
  if (times == 0 || node.op != Op::symbol || tree_.symbols[node.symbol].derivation) return std::nullopt;
  const std::string order = times == 1 ? "" : "^" + std::to_string(times);
  std::string above = "d" + order;
  above += plain_symbol(node.symbol, node, {}, 0).text;
  return Piece{fmt::format("\\left(\\frac{{{}}}{{dt{}}}\\right)_{{\\text{{{}}}}}", above, order,
                           notation_.frame->fixed)};
}

/// A_i' is the sum of λ_i'i A_i over i, each axis of a tensor with a cosine of its own.
std::optional<LatexPrinter::Piece> LatexPrinter::primed_component(ExprId id) {
  std::vector<IndexId> summed;
  for (; tree_[id].op == Op::index_sum; id = child(id)) summed.push_back(tree_[id].index);
  if (tree_[id].op != Op::multiply || tree_.children(id).size() != summed.size() + 1) return std::nullopt;
  const ExprId last = tree_.children(id).back();
  const ExprNode& node = tree_[last];
  if (node.op != Op::symbol || tree_.symbols[node.symbol].derivation || node.slot_count == 0)
    return std::nullopt;
  std::vector<Slot> slots(tree_.slots(last).begin(), tree_.slots(last).end());
  std::size_t cosine = 0;
  for (Slot& slot : slots) {
    const auto is_it = [&](IndexId index) { return slot.axis == 0 && index == slot.variable; };
    if (std::ranges::none_of(summed, is_it)) continue;
    if (cosine == summed.size()) return std::nullopt;
    const ExprId each = child(id, cosine++);
    const auto its = tree_.slots(each);
    const bool carries = tree_[each].op == Op::symbol && tree_.symbols[tree_[each].symbol].rotation &&
                         its.size() == 2 &&
                         is_it(its[1].axis == 0 ? its[1].variable : IndexId{0xffffffffu}) &&
                         its[0].axis == 0 && tree_.name(its[0].variable) == tree_.name(slot.variable) + "'";
    if (!carries) return std::nullopt;
    slot = its[0];
  }
  if (cosine != summed.size()) return std::nullopt;
  return plain_symbol(node.symbol, node, slots, 0);
}

/// e_i' has the components λ_i'1, λ_i'2, λ_i'3.
std::optional<LatexPrinter::Piece> LatexPrinter::primed_basis(ExprId id) const {
  if (tree_[id].op != Op::tuple || tree_[id].rank != 1 || tree_[id].count != all_axes.size())
    return std::nullopt;
  std::string primed;
  for (const std::uint8_t axis : all_axes) {
    const ExprId each = child(id, axis - 1u);
    const auto slots = tree_.slots(each);
    const ExprNode& node = tree_[each];
    if (node.op != Op::symbol || !tree_.symbols[node.symbol].rotation || slots.size() != 2 ||
        slots[1].axis != axis)
      return std::nullopt;
    const std::string first = slot_text(slots[0], false);
    if (axis > 1 && (first != primed || node.symbol != tree_[child(id)].symbol)) return std::nullopt;
    primed = first;
  }
  if (!primed.ends_with('\'')) primed += '\'';
  return Piece{notation_.basis + subscript(primed)};
}

/// The tensor whose nine components these are, in rows.
std::optional<std::string> LatexPrinter::whole_tensor(ExprId id) {
  if (tree_[id].op != Op::determinant) return std::nullopt;
  const ExprNode& node = tree_[child(id)];
  if (node.op != Op::symbol || node.slot_count != 2) return std::nullopt;
  for (std::uint8_t row = 1; row <= 3; ++row) {
    for (std::uint8_t column = 1; column <= 3; ++column) {
      const ExprId each = child(id, 3u * (row - 1u) + column - 1u);
      if (!has_axes(each, node.symbol, {row, column}) || tree_[each].particle != node.particle)
        return std::nullopt;
    }
  }
  if (tree_.symbols[node.symbol].derivation) return std::nullopt;
  return plain_symbol(node.symbol, node, {}, 0).text;
}

}  // namespace rigor
