// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that every library computes to the last place, but which a tree spells out as a quotient of sines
// and cosines or of exponentials, because that is how they are decided. Only where the notes have the name:
// `\tanh x` is one call, and a written quotient of exponentials stays a quotient.
#pragma once

#include <optional>

#include "expr/tree/tree.h"
#include "numeric/program/code.h"

namespace rigor {

struct LibraryFunction {
  Instruction instruction = Instruction::tan;
  ExprId argument{};
};

/// Of a quotient. Nothing where it was changed since it was spelled out.
[[nodiscard]] std::optional<LibraryFunction> library_function(const ExprTree& tree, ExprId quotient);

}  // namespace rigor
