// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/among.h"
#include "elaborate/name/names.h"

namespace rigor {

/// `x(0)`, `V(r_0)`, `\int_a^bf\,dx`: the value of a function at its argument, or of an integral, which is a
/// symbol of its own. What it is follows from the function, so that a row about it defines nothing.
[[nodiscard]] inline bool is_function_value(const Names& names, const ExprTree& tree, SymbolId symbol) {
  const SymbolId base = base_of(tree.symbols, symbol);
  return tree.symbols[base].integral || names.symbols.function_values.contains(base);
}

/// Does an equation of the section show that a letter changes? Words such as "variable mass" do not count:
/// beside the variable of an integral, which is written, other letters are constants.
[[nodiscard]] inline bool changes_in_section(const Names& names, SymbolId symbol) {
  const NameKey* key = key_of(names.symbols, symbol);
  const std::set<std::string>& may_change = names.symbols.evidence->may_change;
  return key != nullptr &&
         (may_change.contains(changing_name(key->base)) || is_changing(*names.symbols.evidence, key->base));
}

/// The symbols below a node, and those of its integrals; `averaged`: and of its averages.
[[nodiscard]] inline std::vector<SymbolId> letters_in(const ExprTree& tree, ExprId root,
                                                      bool averaged = true) {
  std::vector<SymbolId> letters = symbols_in(tree, root);
  for (std::size_t k = 0; k < letters.size(); ++k) {
    const auto& integral = tree.symbols[base_of(tree.symbols, letters[k])].integral;
    if (!integral || (integral->average && !averaged)) continue;
    for (const ExprId part : parts_of(*integral)) {
      for (const SymbolId inside : symbols_in(tree, part)) {
        if (!is_one_of(inside, letters)) letters.push_back(inside);
      }
    }
  }
  return letters;
}

}  // namespace rigor
