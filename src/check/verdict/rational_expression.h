// SPDX-License-Identifier: GPL-3.0-or-later
// An exact value of a sample as a part of another question.
#pragma once

#include <optional>
#include <string>

#include "expr/statement/statement.h"

namespace rigor {

/// `-3/2` as an expression; nothing of `0.693147`, which is rounded.
[[nodiscard]] std::optional<ExprId> add_rational(ExprTree& tree, Span span, const std::string& value);

/// `\int_0^1 x^2\,dx = 0.333`: decimals of an integral are not compared digit by digit.
[[nodiscard]] bool may_be_rounded(const ExprTree& tree, const Equation& claim, const Sample& sample);

}  // namespace rigor
