// SPDX-License-Identifier: GPL-3.0-or-later
// The physical dimension of an expression, from those of the letters in it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "expr/statement/statement.h"

namespace rigor {

struct QuantityDimension {
  std::optional<Dimension> dimension;  // nothing: it depends on a letter whose dimension is not known
  std::string clash;                   // terms of different dimensions: says which; else empty
};

/// `dimension_of`: of a symbol that is no derivative. Symbols without one are unfolded by the last definition
/// of theirs. Definitions in a circle give nothing.
[[nodiscard]] QuantityDimension quantity_dimension(
    const ExprTree& tree, std::span<const Definition> definitions, ExprId root,
    const std::function<std::optional<Dimension>(SymbolId)>& dimension_of);

/// In base units: `kg m^2/s^2`, `1/s`, `1` for a pure number.
[[nodiscard]] std::string si_unit(const Dimension& dimension);

}  // namespace rigor
