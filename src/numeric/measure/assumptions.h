// SPDX-License-Identifier: GPL-3.0-or-later
// Equations and orders on samples in double, each side with its error bound.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "expr/statement/statement.h"
#include "numeric/program/samples.h"

namespace rigor {

enum class Holds : std::uint8_t {
  yes,   // within the bounds
  no,    // beyond the bounds
  open,  // a bound is infinite, or too large to tell
};

/// All components on all samples; of what belongs to particles, for each of them (free ones together the
/// same). `uncertainty`: of the inputs, relative. Fails where a side cannot be compiled.
[[nodiscard]] Result<Holds> holds(const ExprTree& tree, std::span<const Definition> definitions,
                                  const Equation& equation, const Samples& samples, double uncertainty);

/// All of them, and none is open.
[[nodiscard]] bool meets_all(const ExprTree& tree, std::span<const Definition> definitions,
                             std::span<const Equation> assumptions, const Samples& samples,
                             double uncertainty);

}  // namespace rigor
