// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials multiplied out. GiNaC's own expansion builds an expression for each intermediate product; here
// a term is a packed vector of exponents and a number until the end.
#pragma once

#include <ginac/ex.h>

namespace rigor {

/// The same value as a sum of terms, like `ex::expand`, for an expression of rational numbers and symbols
/// with +, × and whole powers. Anything else, and a degree above 255, is left to GiNaC.
[[nodiscard]] GiNaC::ex expanded_polynomial(const GiNaC::ex& value);

}  // namespace rigor
