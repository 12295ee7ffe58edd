// SPDX-License-Identifier: GPL-3.0-or-later
// Letters for what is summed over, as a lecturer would choose them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

struct LetterChoice {
  std::vector<std::string> indices = {};    // in this order, then i, j, k, l, m, n, p, q, …
  std::vector<std::string> particles = {};  // in this order, then α, β, γ, …
  std::set<std::string> taken = {};         // of free indices and particles
};

/// The letters that an expression sums over, in order of appearance, added to the choice.
void note_letters(const ExprTree& tree, ExprId root, LetterChoice& choice);

/// The same expression; a sum keeps its letter if the letter is not in use around it or elsewhere in its
/// product; else it gets the first free one, numbered if all letters are taken. Terms of a sum share letters.
[[nodiscard]] ExprId with_letters(ExprTree& tree, ExprId root, const LetterChoice& choice);

}  // namespace rigor
