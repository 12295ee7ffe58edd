// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials along a line through the space of their indeterminates, modulo a prime. What divides a
// polynomial divides its image, and a square in it is a square there; so a look at the image, which takes
// microseconds, says no for certain where a long division, or GiNaC, takes milliseconds to say it.
#pragma once

#include <ginac/ex.h>

#include "algebra/packed/packed_letters.h"

namespace rigor {

/// Whether a polynomial can be a multiple of another; false is certain.
[[nodiscard]] bool may_divide(const PackedPolynomial& divisor, const PackedPolynomial& value,
                              const PackedLetters& letters);

/// Whether a polynomial with rational coefficients can have a factor more than once, a number
/// aside; false is certain.
[[nodiscard]] bool may_repeat_a_factor(const GiNaC::ex& value);

}  // namespace rigor
