// SPDX-License-Identifier: GPL-3.0-or-later
// A number for each node, so that most expressions can be told apart without a walk through both.
#include <algorithm>
#include <string_view>

#include "base/splitmix.h"
#include "expr/tree/tree.h"

namespace rigor {
namespace {

constexpr std::uint64_t likeness_of_zero = 1;

std::uint64_t joined(std::uint64_t mark, std::uint64_t next) { return SplitMix(mark ^ next).next(); }

bool is_zero_number(std::string_view digits) {
  return std::ranges::all_of(digits, [](char c) { return c == '0' || c == '.'; });
}

std::uint64_t mark_of(std::string_view digits) {
  std::uint64_t mark = digits.size();
  for (const char digit : digits) mark = joined(mark, static_cast<unsigned char>(digit));
  return mark;
}

}  // namespace

/// What `same_expression` passes over makes no difference: names of bound indices and particles, ranks of a
/// written 0, first powers, the order of sums in one another, brackets in a product and its order.
std::uint64_t ExprTree::likeness_of(const ExprNode& node) const {
  const std::span<const ExprId> children(node.first_child, node.count);
  const auto likeness = [this](ExprId id) { return (*this)[id].likeness; };
  const auto is_zero = [&](ExprId id) { return likeness(id) == likeness_of_zero; };
  if (node.op == Op::power && node.exponent == 1) return likeness(children[0]);
  if (node.op == Op::number && is_zero_number(numbers_[node.payload])) return likeness_of_zero;
  const bool of_values = node.op == Op::component || node.op == Op::tuple;
  if (of_values && std::ranges::all_of(children, is_zero)) return likeness_of_zero;
  if (node.op == Op::multiply) {
    std::uint64_t sum = 0;
    for (ExprId child : children) {
      while ((*this)[child].op == Op::power && (*this)[child].exponent == 1) child = this->children(child)[0];
      const bool is_product = (*this)[child].op == Op::multiply;
      sum += is_product ? likeness(child) : joined(0, likeness(child));
    }
    return sum;
  }
  const bool of_symbol = node.op == Op::component && (*this)[children[0]].op == Op::symbol &&
                         (*this)[children[0]].slot_count == 0;
  const ExprNode& shown = of_symbol ? (*this)[children[0]] : node;
  std::uint64_t mark = static_cast<std::uint64_t>(shown.op) + 2;
  if (shown.op == Op::number) mark = joined(mark, mark_of(numbers_[shown.payload]));
  if (shown.op == Op::symbol) mark = joined(mark, static_cast<std::uint64_t>(shown.symbol));
  if (shown.op == Op::power) mark = joined(mark, static_cast<std::uint32_t>(shown.exponent));
  if (shown.op == Op::function) mark = joined(mark, static_cast<std::uint64_t>(shown.function));
  for (const Slot& slot : std::span(node.first_slot, node.slot_count)) mark = joined(mark, slot.axis);
  if (of_symbol) return mark;
  for (const ExprId child : children) mark = joined(mark, likeness(child));
  return mark;
}

}  // namespace rigor
