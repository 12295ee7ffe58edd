// SPDX-License-Identifier: GPL-3.0-or-later
// States in Dirac's notation: kets as symbols by their names, and what a product of them is. A bra is the
// adjoint of a ket.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// The parts of a name as the parser spells it: `j, m+1`.
[[nodiscard]] std::vector<LabelPart> label_of(std::string_view text);
[[nodiscard]] std::string text_of_label(const std::vector<LabelPart>& label);
/// Does its letter number states, as n does? Then a rule for it is one for each n.
[[nodiscard]] bool numbers_states(const LabelPart& part);

/// Always the same one of a name.
SymbolId symbol_of_ket(ExprTree& tree, const std::vector<LabelPart>& label, Span span);
/// δ of two states by their numbers: 1, 0, or a symbol.
ExprId kronecker_of_states(ExprTree& tree, LabelPart first, LabelPart second, Span span);
[[nodiscard]] inline bool is_kronecker_of_states(const Symbol& symbol) {
  return !symbol.ket && !symbol.label.empty();
}

/// A number can stand for a multiple of the unit operator; `none`: the factors or terms do not fit together.
enum class StateShape : std::uint8_t { number, operators, ket, bra, none };

[[nodiscard]] bool holds_states(const ExprTree& tree, ExprId root);
/// Recursion: as deep as the tree.
[[nodiscard]] StateShape state_shape(const ExprTree& tree, ExprId root);

}  // namespace rigor
