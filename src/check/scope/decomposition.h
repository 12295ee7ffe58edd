// SPDX-License-Identifier: GPL-3.0-or-later
// `T_{ij} = S_{ij} + A_{ij}`, and below it `S_{ij} = \tfrac12(T_{ij} + T_{ji})`: the first equation does not
// say what T is. It takes T apart, and the second one says what a part is.
#pragma once

#include <optional>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

struct Decomposition {
  Definition whole;           // its body is the sum
  Origin origin;              // of the sum
  std::vector<ExprId> parts;  // as they are there: bare symbols with the letters of the whole
};

/// The sum that an equation of the notes in the same section, `place`, says with the bare symbol `part` among
/// its terms, where `made_of` has the whole and no other term of the sum.
[[nodiscard]] std::optional<Decomposition> decomposition(const ExprTree& tree, const Names& names,
                                                         ExprId part, ExprId made_of, std::size_t place);

/// From here on the sum does not say what the whole is. It says what its last part is where all others but
/// `part` are defined, and is an equation between the parts where more are open.
void take_apart(ExprTree& tree, Names& names, const Decomposition& apart, SymbolId part);

}  // namespace rigor
