// SPDX-License-Identifier: GPL-3.0-or-later
// Division of expanded polynomials, and their repeated factors, by GiNaC. A look along a line
// (`line_image.h`) rules most cases out first. The work is counted.
#pragma once

#include <ginac/ginac.h>

#include <cstddef>

#include "algebra/engine/budget.h"
#include "algebra/packed/numerator.h"

namespace rigor {

/// Pairs of a term of each, weighed by the degree: each step of a long division goes over all terms. A unit
/// is `price::divided_pair`. Cost: linear in the terms of the dividend.
[[nodiscard]] std::size_t size_of_division(const GiNaC::ex& divisor, const GiNaC::ex& value);

/// Whether a polynomial divides another, and what times, expanded. The budget may be none.
[[nodiscard]] bool divides(const Numerator& divisor, const Numerator& value, Numerator& quotient,
                           const PackedLetters& letters, Budget* budget);
[[nodiscard]] bool divides(const GiNaC::ex& divisor, const GiNaC::ex& value, GiNaC::ex& quotient,
                           Budget* budget);

/// May factors be looked for? GiNaC's greatest common divisors have no bound of their own; so many monomials
/// as fit under the degrees of a polynomial are one.
[[nodiscard]] bool may_be_factored(const GiNaC::ex& expanded);

/// A polynomial as a product of powers, if it has a factor more than once.
[[nodiscard]] GiNaC::ex with_repeated_factors(const GiNaC::ex& value, Budget* budget);

}  // namespace rigor
