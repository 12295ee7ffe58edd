// SPDX-License-Identifier: GPL-3.0-or-later
// Exact rational numbers (CLN's; small integers cost no memory), and how they are written: `3`, `-3/2`.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <string>
#include <string_view>

#include "expr/statement/statement.h"

namespace rigor {

using Rational = cln::cl_RA;

/// From the digits of a number node, `2` or `0.25`.
[[nodiscard]] Rational from_digits(const std::string& digits);

/// From what `to_text` writes; empty if it is not that.
[[nodiscard]] std::optional<Rational> from_text(std::string_view text);

[[nodiscard]] std::string to_text(const Rational& value);

/// The non-negative square root, if it is rational.
[[nodiscard]] std::optional<Rational> exact_root(const Rational& value);

/// Do two numbers stand in a relation?
[[nodiscard]] bool is_related(const Rational& left, Relation relation, const Rational& right);

/// Binary digits of numerator and denominator together.
[[nodiscard]] double bit_size(const Rational& value);

/// base^exponent; a negative exponent needs a base that is not 0.
[[nodiscard]] Rational power_of(const Rational& base, int exponent);

}  // namespace rigor
