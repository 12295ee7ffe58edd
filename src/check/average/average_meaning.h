// SPDX-License-Identifier: GPL-3.0-or-later
// What one average of the page says of the others: beside `\langle E\rangle = \sum_s p_sE_s`, the average of
// E^2 is `\sum_s p_sE_s^2`; beside `\langle x\rangle = \int x\rho\,dx`, that of x^2 is `\int x^2\rho\,dx`.
#pragma once

#include <optional>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// `law`: an average, and a sum over members or an integral that has what is averaged as a factor of its own.
/// What stands in the other average has to be reckoned from what is known of each member, or from the
/// variable of the integral alone: `\langle p^2\rangle` is none of these.
[[nodiscard]] std::optional<Equation> meaning_of_average(ExprTree& tree, const Names& names, SymbolId average,
                                                         const Equation& law);

}  // namespace rigor
