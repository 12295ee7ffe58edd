// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/trivial_statement.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace rigor {
namespace {

bool is_zero_as_written(const ExprTree& tree, ExprId id) {
  const auto children = tree.children(id);
  const auto is_zero = [&](ExprId child) { return is_zero_as_written(tree, child); };
  switch (tree[id].op) {
    case Op::number:
      return tree.is_zero_literal(id);
    case Op::add:
    case Op::negate:
    case Op::tuple:
      return std::ranges::all_of(children, is_zero);
    case Op::multiply:
    case Op::dot:
    case Op::cross:
      return std::ranges::any_of(children, is_zero);
    default:
      return false;
  }
}

/// Two terms of the sum are the same but for their signs.
bool has_cancelling_terms(const ExprTree& tree, ExprId side) {
  std::set<std::string> terms[2];
  std::vector<std::pair<ExprId, bool>> pending{{side, false}};
  while (!pending.empty()) {
    const auto [id, negative] = pending.back();
    pending.pop_back();
    const Op op = tree[id].op;
    if (op == Op::add || op == Op::negate) {
      for (const ExprId child : tree.children(id))
        pending.emplace_back(child, negative != (op == Op::negate));
      continue;
    }
    const std::string term = dump(tree, id);
    if (terms[negative ? 0 : 1].contains(term)) return true;
    terms[negative ? 1 : 0].insert(term);
  }
  return false;
}

}  // namespace

bool is_trivial(const ExprTree& tree, ExprId left, ExprId right) {
  return dump(tree, left) == dump(tree, right) || has_cancelling_terms(tree, left) ||
         has_cancelling_terms(tree, right) ||
         (is_zero_as_written(tree, left) && is_zero_as_written(tree, right));
}

}  // namespace rigor
