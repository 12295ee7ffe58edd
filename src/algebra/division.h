// SPDX-License-Identifier: GPL-3.0-or-later
// Division and repeated factors of expanded polynomials, by GiNaC, and only where a look along a line does
// not rule them out; what it takes is counted.
#pragma once

#include <ginac/ginac.h>

#include "algebra/budget.h"

namespace rigor {

/// Whether a polynomial divides another, and what times, expanded. The budget may be none.
[[nodiscard]] bool divides(const GiNaC::ex& divisor, const GiNaC::ex& value, GiNaC::ex& quotient,
                           Budget* budget);

/// A polynomial as a product of powers, if it has a factor more than once.
[[nodiscard]] GiNaC::ex with_repeated_factors(const GiNaC::ex& value, Budget* budget);

}  // namespace rigor
