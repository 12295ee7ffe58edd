// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/function_values.h"

#include <algorithm>
#include <vector>

#include "check/question/unread.h"
#include "elaborate/name/function_value.h"

namespace rigor {

bool speaks_of_values(const Question& question, const Names& names) {
  const ExprTree& tree = *question.tree;
  const std::vector<Definition>& known = question.definitions;
  const auto& values = names.symbols.function_values;
  const auto is_plain = [&](ExprId at) { return tree[at].op == Op::symbol || tree[at].op == Op::number; };
  return std::ranges::any_of(symbols_of(question), [&](SymbolId symbol) {
    const auto value = values.find(base_of(tree.symbols, symbol));
    if (value == nullptr) return false;
    const bool is_known = std::ranges::find(known, symbol, &Definition::symbol) != known.end();
    return !is_known || !std::ranges::all_of(value->second.at, is_plain);
  });
}

}  // namespace rigor
