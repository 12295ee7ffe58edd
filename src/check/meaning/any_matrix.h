// SPDX-License-Identifier: GPL-3.0-or-later
// Are the matrices of a statement any matrices? The words have to call them so, and nothing else of them.
#pragma once

#include <optional>
#include <string>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

[[nodiscard]] bool is_about_matrices(const ExprTree& tree, const Equation& claim);

/// "`symmetric` in its section may say which are meant"; nothing where all are meant.
[[nodiscard]] std::optional<std::string> why_not_all_matrices(const ExprTree& tree, const Names& names,
                                                              const Equation& claim);

}  // namespace rigor
