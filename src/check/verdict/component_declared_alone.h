// SPDX-License-Identifier: GPL-3.0-or-later
// `scalar I_1` together with `I_{ij} = I_i\delta_{ij}`: two symbols to us, and perhaps one to the author.
#pragma once

#include <optional>
#include <string>

#include "expr/statement/statement.h"

namespace rigor {

/// The names of a number that is declared by itself and of the vector whose component it can be.
struct DeclaredComponent {
  std::string component;
  std::string vector;
};
/// The first such pair among the symbols of the claim, the definitions and the assumptions.
[[nodiscard]] std::optional<DeclaredComponent> component_declared_alone(const Question& question);

}  // namespace rigor
