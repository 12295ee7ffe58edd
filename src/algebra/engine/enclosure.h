// SPDX-License-Identifier: GPL-3.0-or-later
// Real numbers between two rational ones: what roots, logarithms, angles and π are at a rational point. The
// bounds are rounded outwards to `enclosure_bits` binary digits. Functions are evaluated by CLN with twice as
// many digits, and their bounds are widened by far more than CLN's last digit.
#pragma once

#include "algebra/engine/exact_number.h"
#include "expr/tree/tree.h"

namespace rigor {

struct Enclosure {
  Rational low;
  Rational high;  // not below `low`
};

inline constexpr int enclosure_bits = 128;

[[nodiscard]] Enclosure sum(const Enclosure& a, const Enclosure& b);
[[nodiscard]] Enclosure opposite(const Enclosure& value);
[[nodiscard]] Enclosure product(const Enclosure& a, const Enclosure& b);
/// Throws PointRejected where the divisor may be 0.
[[nodiscard]] Enclosure quotient(const Enclosure& a, const Enclosure& b);
[[nodiscard]] Enclosure power(const Enclosure& base, int exponent);
/// Throw PointRejected where there may be no real value, or one too large to be of use.
[[nodiscard]] Enclosure root(const Enclosure& square);
[[nodiscard]] Enclosure applied(Function function, const Enclosure& argument);
[[nodiscard]] Enclosure circle_number();

/// A decimal of six digits, `0.693147`: its point tells it from an exact number.
[[nodiscard]] std::string to_text(const Enclosure& value);

}  // namespace rigor
