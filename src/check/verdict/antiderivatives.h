// SPDX-License-Identifier: GPL-3.0-or-later
// Equations between integrals without limits. Such an integral stands for all functions with one derivative,
// so what the equation says is that the derivatives of its sides are equal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elaborate/reading/reading.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Does an integral without limits stand there?
[[nodiscard]] bool has_antiderivative(const ExprTree& tree, ExprId root);

struct Differentiated {
  Equation equation;
  std::string by;  // the variable
};

/// The equation of the derivatives. `sides`: of the whole chain, one of which may show that no integral over
/// all values is meant. Nothing, and a diagnostic, where it is not understood.
[[nodiscard]] std::optional<Differentiated> differentiated(Reading& reading, const Equation& equation,
                                                           const std::vector<ExprId>& sides, Span place,
                                                           Diagnostics& diagnostics);

}  // namespace rigor
