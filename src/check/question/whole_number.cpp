// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/whole_number.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace rigor {

std::optional<int> whole_number_of(const ExprTree& tree, ExprId id) {
  constexpr int largest = 1'000'000'000;
  const auto bounded = [](long long value) {
    return std::llabs(value) <= largest ? std::optional(static_cast<int>(value)) : std::nullopt;
  };
  const ExprNode& node = tree[id];
  if (node.op == Op::number) {
    const std::string& digits = tree.digits(id);
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? bounded(value) : std::nullopt;
  }
  if (node.op != Op::negate && node.op != Op::add && node.op != Op::multiply && node.op != Op::divide)
    return std::nullopt;
  long long result = node.op == Op::multiply ? 1 : 0;
  bool is_first = true;
  for (const ExprId child : tree.children(id)) {
    const auto value = whole_number_of(tree, child);
    if (!value) return std::nullopt;
    if (node.op == Op::divide && !is_first && (*value == 0 || result % *value != 0)) return std::nullopt;
    if (node.op == Op::negate) result = -*value;
    if (node.op == Op::add) result += *value;
    if (node.op == Op::multiply) result *= *value;
    if (node.op == Op::divide) result = is_first ? *value : result / *value;
    is_first = false;
    if (!bounded(result)) return std::nullopt;
  }
  return bounded(result);
}

}  // namespace rigor
