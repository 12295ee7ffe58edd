// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict that holds for real numbers, but need not hold for what the letters can also be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

struct OtherReading {
  std::string message;
  std::vector<std::string> help = {};
};

/// Why the claim is neither proved nor refuted, though it is for real numbers: its letters can be matrices or
/// operators, whose order matters, complex numbers, or matrices whose determinant is taken. `question` has
/// the claim with what it was decided from.
[[nodiscard]] std::optional<OtherReading> other_reading(const Question& question, const Names& names,
                                                        bool proved);

/// Does the claim hold for matrices and operators, in their order, with 1 for the letter that the section
/// calls the unit matrix? False if it calls none so.
[[nodiscard]] bool holds_with_unit_matrix(const Question& question, const Names& names);

}  // namespace rigor
