// SPDX-License-Identifier: GPL-3.0-or-later
// Results of programs in rational numbers: decides what is exactly 0, and what divides by 0.
#pragma once

#include <span>

#include "numeric/measure/reference.h"

namespace rigor {

/// Unknown where a sample has a root or a function that is not rational, or would take too long: the lengths
/// of all numbers are counted as they grow.
[[nodiscard]] ReferenceDigits exact_results(const Program& program, const Samples& samples,
                                            std::span<const std::uint32_t> at);

}  // namespace rigor
