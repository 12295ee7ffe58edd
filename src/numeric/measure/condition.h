// SPDX-License-Identifier: GPL-3.0-or-later
// How much a program's result depends on its inputs: Σ_i |x_i ∂f/∂x_i| / |f|, with the largest component for
// a vector. An input that is known to a relative u makes the result uncertain by at most this many u, however
// it is computed. By reverse differentiation of the program, loops over particles included, with 100 digits
// and a running error bound; with 400 and 1,400 where the bound is too large.
// Memory and time grow with (values in loops) × particles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"

namespace rigor {

/// One for each sample; infinite where the result is 0 or has no derivative, 0 where it is less than 2^-60,
/// NaN where it is undefined or not known to 20 bits. Fewer than there are samples, or none, where all would
/// take more than `budget` operations with 100 digits; more digits are taken where a like share of time
/// allows.
[[nodiscard]] std::vector<double> condition_numbers(const Program& program, const Samples& samples,
                                                    std::span<const std::uint32_t> at = {},
                                                    std::size_t budget = 2'000'000);

}  // namespace rigor
