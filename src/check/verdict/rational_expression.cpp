// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/rational_expression.h"

namespace rigor {

std::optional<ExprId> add_rational(ExprTree& tree, Span span, const std::string& value) {
  if (value.find('.') != std::string::npos) return std::nullopt;
  const bool negative = value.starts_with('-');
  const std::string digits = negative ? value.substr(1) : value;
  const auto slash = digits.find('/');
  ExprId number = tree.add_number(span, digits.substr(0, slash));
  if (slash != std::string::npos) {
    const ExprId parts[] = {number, tree.add_number(span, digits.substr(slash + 1))};
    number = tree.add({.op = Op::divide, .span = span}, parts);
  }
  return negative ? tree.add({.op = Op::negate, .span = span}, std::span(&number, 1)) : number;
}

}  // namespace rigor
