// SPDX-License-Identifier: GPL-3.0-or-later
// Which letters a family of inputs is about.
#pragma once

#include <optional>
#include <string>

#include "expr/tree/symbol.h"

namespace rigor {

/// A scalar whose subscript is a number: `I_{2}` is (`I`, 2).
struct NumberedLetter {
  std::string base;
  int number = 0;
};

[[nodiscard]] std::optional<NumberedLetter> numbered_letter(const Symbol& symbol);

/// A vector that belongs to no particle.
[[nodiscard]] bool is_free_vector(const Symbol& symbol);

/// Are its components, or eigenvalues, what a `gap` sets apart? Those of a symmetric tensor, and of a letter
/// with one index that is not set as a vector, such as the principal values `I_i`.
[[nodiscard]] bool has_gap_between_components(const Symbol& symbol);

}  // namespace rigor
