// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/any_matrix.h"

#include <fmt/format.h>

#include "elaborate/evidence/evidence.h"
#include "expr/tree/unsized.h"

namespace rigor {

bool is_about_matrices(const ExprTree& tree, const Equation& claim) {
  return is_unsized(tree, claim.left) || is_unsized(tree, claim.right);
}

std::optional<std::string> why_not_all_matrices(const ExprTree& tree, const Names& names,
                                                const Equation& claim) {
  if (!is_about_matrices(tree, claim)) return std::nullopt;
  const UnsizedMatrices& said = names.symbols.evidence->unsized;
  if (!said.special.empty()) return fmt::format("`{}` in its section may say which are meant", said.special);
  for (const ExprId side : {claim.left, claim.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const Symbol& letter = tree.symbols[symbol];
      const bool matrix = letter.unsized != Unsized::none && letter.unsized != Unsized::column;
      if (matrix && !said.called.contains(letter.name))
        return fmt::format("nothing says that `{}` is any matrix", letter.name);
    }
  }
  return std::nullopt;
}

}  // namespace rigor
