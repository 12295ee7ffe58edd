// SPDX-License-Identifier: GPL-3.0-or-later
// Results of programs without roots and functions in rational numbers: decides what is exactly 0.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "numeric/reference_digits.h"

namespace rigor {

/// Nothing where the program has a root or a function, divides by 0, or would take too long.
[[nodiscard]] std::optional<std::vector<ReferenceNumber>> exact_results(const Program& program,
                                                                        const Samples& samples,
                                                                        std::span<const std::uint32_t> at);

}  // namespace rigor
