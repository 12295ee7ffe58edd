// SPDX-License-Identifier: GPL-3.0-or-later
// What an expression comes to where its letters are measured: a number in base units of the SI, and its
// dimension.
#pragma once

#include <map>
#include <optional>

#include "elaborate/name/names.h"

namespace rigor {

struct MeasuredValue {
  double number = 0;
  Dimension dimension = {};
};

/// Values of letters that nothing defines.
using MeasuredLetters = std::map<SymbolId, MeasuredValue>;

/// Definitions are put in. Nothing where a letter has no value, where that is no real number, or where
/// dimensions do not fit. In floating point: to choose what is then decided exactly.
[[nodiscard]] std::optional<MeasuredValue> measured_value(const ExprTree& tree, const Names& names,
                                                          ExprId expr, const MeasuredLetters& letters);

}  // namespace rigor
