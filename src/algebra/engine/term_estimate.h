// SPDX-License-Identifier: GPL-3.0-or-later
// How long an expression may become, known before it is multiplied out.
#pragma once

#include <ginac/ex.h>

namespace rigor {

/// An upper bound for the terms of numerator and denominator when the expression is brought over one
/// denominator and multiplied out, before equal terms are collected. Cost: linear in the expression as it is
/// written.
[[nodiscard]] double most_terms_over_one_denominator(const GiNaC::ex& value);

}  // namespace rigor
