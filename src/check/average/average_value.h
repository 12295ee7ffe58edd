// SPDX-License-Identifier: GPL-3.0-or-later
// What an average is, as far as linearity says: `\langle a(x + 1)\rangle = a\langle x\rangle + a`. Of
// products of what changes from outcome to outcome nothing is known but their own averages: they multiply
// nothing, and no function goes in or out. Products of operators keep their order.
//
// Which letters are the same for all outcomes, the section shows (`evidence/averaged_letters.cpp`). One of
// which nothing is known is left inside, which loses proofs and cannot make one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elaborate/name/names.h"

namespace rigor {

struct AverageValue {
  ExprId value{};
  std::vector<std::string> conventions = {};  // that it rests on
};

/// Puts definitions in; nothing where they cannot be.
using Opener = std::function<std::optional<ExprId>(ExprId)>;

/// Of the symbol of an average. Nothing where it cannot be read so, or where nothing in it is left to be
/// averaged, though nobody says that its letters are constants.
[[nodiscard]] std::optional<AverageValue> value_of_average(ExprTree& tree, const Names& names,
                                                           SymbolId average, const Opener& opened);

/// What a law of operators, which holds in every state, says of averages.
[[nodiscard]] std::optional<Equation> averaged_law(ExprTree& tree, const Names& names, const Equation& law,
                                                   const Opener& opened);

/// Does it change from outcome to outcome, for all that is known?
[[nodiscard]] bool may_fluctuate(const ExprTree& tree, const Names& names, SymbolId symbol);
/// Does the section show that it does: by its average alone, or in words?
[[nodiscard]] bool fluctuates_surely(const ExprTree& tree, const Names& names, SymbolId symbol);

/// Is it the average itself, or a derivative of one?
[[nodiscard]] inline bool is_average(const ExprTree& tree, SymbolId symbol) {
  const auto& integral = tree.symbols[base_of(tree.symbols, symbol)].integral;
  return integral && integral->average;
}

}  // namespace rigor
