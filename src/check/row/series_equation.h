// SPDX-License-Identifier: GPL-3.0-or-later
// Two sides as power series of a letter that goes to 0, and what their coefficients must be.
#pragma once

#include <optional>
#include <vector>

#include "check/place/place.h"

namespace rigor {

class DecisionCache;

/// Where series are expanded: what holds there, and where the exact side is asked.
struct SeriesPlace {
  ExprTree& tree;
  const Names& names;
  DecisionCache* cache;
  Directives* used = nullptr;  // the directives that were looked up, if that is wanted
};

/// Between the coefficients of one power.
struct SeriesEquation {
  int order = 0;
  Equation equation;
};

/// What holds of the letter alone, so that all other symbols can be held while it goes to 0.
[[nodiscard]] std::optional<Equation> with_letter_open(const SeriesPlace& place, Equation equation,
                                                       SymbolId letter);
/// The equations between the coefficients of powers below `power`; nothing where a side has no expansion.
[[nodiscard]] std::optional<std::vector<SeriesEquation>> coefficients(const SeriesPlace& place,
                                                                      const Equation& equation,
                                                                      SymbolId letter, int power);
/// One equation between polynomials of the letter that says the same.
[[nodiscard]] std::optional<Equation> equation_up_to(const SeriesPlace& place, const Equation& equation,
                                                     SymbolId letter, int power);

}  // namespace rigor
