// SPDX-License-Identifier: GPL-3.0-or-later
// Systems of linear equations with rational numbers.
#pragma once

#include <optional>
#include <vector>

#include "algebra/engine/exact_number.h"

namespace rigor {

/// Columns of coefficients, each as long as the right side.
using LinearColumns = std::vector<std::vector<Rational>>;

/// One solution of Σ x_k column_k = right, or none. Unknowns that come late are 0 where earlier ones do.
[[nodiscard]] std::optional<std::vector<Rational>> solve_linear(LinearColumns columns,
                                                                std::vector<Rational> right);

}  // namespace rigor
