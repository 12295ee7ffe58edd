// SPDX-License-Identifier: GPL-3.0-or-later
// What an equation is about.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The letters that have a value and that it leads to, definitions unfolded, each without its derivatives.
/// The variable of an integral between limits has none.
[[nodiscard]] std::set<SymbolId> base_letters(const ExprTree& tree, const NameScope& scope,
                                              const Equation& equation);

/// Those that stand in it, without their derivatives.
[[nodiscard]] std::set<SymbolId> written_letters(const ExprTree& tree, const Equation& equation);

/// The nodes of these expressions and of the definitions that they lead to.
[[nodiscard]] std::vector<ExprId> nodes_reached(const ExprTree& tree, const NameScope& scope,
                                                std::vector<ExprId> roots);

/// The letter by which some symbols are differentiated with nothing held, if there is one.
[[nodiscard]] std::optional<Variable> only_letter_differentiated_by(const ExprTree& tree,
                                                                    const std::set<SymbolId>& symbols);

/// How often a symbol is differentiated.
struct Orders {
  int time = 0;
  int space = 0;
  int letter = 0;  // by the letter that the claim differentiates by: x of `y''(x)`
  [[nodiscard]] int total() const { return time + space + letter; }
  /// Each to the other's, where that is higher.
  void raise_to(const Orders& other) {
    time = std::max(time, other.time);
    space = std::max(space, other.space);
    letter = std::max(letter, other.letter);
  }
};
[[nodiscard]] inline Orders orders_of(const Symbol& symbol, const std::optional<Variable>& letter) {
  return {symbol.order(By::time), symbol.order(By::space), letter ? symbol.order(*letter) : 0};
}

/// Is anything differentiated in one of them?
[[nodiscard]] bool has_rates(const ExprTree& tree, const std::vector<Equation>& equations,
                             const std::optional<Variable>& letter);

/// Does an assumption other than `but` speak of this letter or its rates?
[[nodiscard]] bool is_assumed_of(const ExprTree& tree, const NameScope& scope, SymbolId letter,
                                 const NamedAssumption* but = nullptr);

/// One of three rules for the components of a derivative, which make a definition together.
[[nodiscard]] bool is_joined(const ExprTree& tree, const NameScope& scope, const Equation& equation);

/// n·n = 1, of a unit vector.
[[nodiscard]] Equation length_is_one(ExprTree& tree, SymbolId vector);

}  // namespace rigor
