// SPDX-License-Identifier: GPL-3.0-or-later
// `1\,\mathrm{fm}^{-1} = 197\,\mathrm{MeV}`, `1\,\mathrm{eV} = 11605\,\mathrm K`: where energies are in
// electronvolts, ħ, c and k_B may be 1, and masses, times and temperatures may be given as energies.
#pragma once

#include <string_view>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// `eV`, `MeV`, `\electronvolt` as it is written.
[[nodiscard]] bool mentions_electronvolts(std::string_view text);

/// Has it an energy in electronvolts, definitions put in, and do the dimensions of its sides differ as far as
/// they are known?
[[nodiscard]] bool may_have_natural_units(const ExprTree& tree, const Names& names, const Equation& equation);

}  // namespace rigor
