// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities as text: `2.5 kg`, `10 cm`, `104.52 deg`, `600 rpm`.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "expr/tree/dimension.h"

namespace rigor {

struct QuantityText {
  double value = 0;  // in SI units; rounded once where the unit is a power of ten of these, else twice
  Dimension dimension = {};
};

/// A finite decimal number and a unit of `read_unit`, or one of `deg`, `°`, `deg/s`, `°/s`, `rpm`, `u`, `Å`.
/// A pure number has no unit.
[[nodiscard]] Result<QuantityText> read_quantity(std::string_view text);

/// `a length (L)`, `an angular velocity (T^{-1})`, `a pure number`; else the dimension alone.
[[nodiscard]] std::string name_of(const Dimension& dimension);

[[nodiscard]] Dimension mass_dimension();
[[nodiscard]] Dimension length_dimension();
[[nodiscard]] Dimension time_dimension();
[[nodiscard]] Dimension rate_dimension();     // 1/T: of an angular velocity
[[nodiscard]] Dimension density_dimension();  // M/L³
[[nodiscard]] Dimension inertia_dimension();  // M L²

}  // namespace rigor
