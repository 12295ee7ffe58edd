// SPDX-License-Identifier: GPL-3.0-or-later
// Units of measure as expressions: a number times powers of positive symbols, one for each base unit.
#pragma once

#include <optional>
#include <string>

#include "elaborate/name/names.h"
#include "latex/unit/units.h"

namespace rigor {

/// Nothing, and why, where a power is too large or no whole number. The symbols that it needs are positive
/// from here on.
[[nodiscard]] std::optional<ExprId> unit_expression(ExprTree& tree, Names& names, const WrittenUnit& unit,
                                                    Span span, std::string* problem = nullptr);

}  // namespace rigor
