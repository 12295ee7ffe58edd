// SPDX-License-Identifier: GPL-3.0-or-later
// An exact value of a sample as a part of another question.
#pragma once

#include <optional>
#include <string>

#include "expr/tree/tree.h"

namespace rigor {

/// `-3/2` as an expression; nothing of `0.693147`, which is rounded.
[[nodiscard]] std::optional<ExprId> add_rational(ExprTree& tree, Span span, const std::string& value);

}  // namespace rigor
