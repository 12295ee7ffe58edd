// SPDX-License-Identifier: GPL-3.0-or-later
// Programs on samples, in every precision.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"

namespace rigor {

/// What is computed with. u, the unit roundoff: 2^-24, 2^-53, 2^-64, about 2^-104.
enum class Arithmetic : std::uint8_t { single, plain, extended, double_double };
inline constexpr std::size_t arithmetic_count = 4;
[[nodiscard]] std::string_view name_of(
    Arithmetic arithmetic);  // `float`, `double`, `long double`, `double-double`

/// results[output · samples + sample], rounded to double at the end. Inputs are rounded to the arithmetic
/// first, with their low parts. `at`: which particle (from 0) each of the program's free particle variables
/// is. A missing input is our own bug.
[[nodiscard]] std::vector<double> evaluate(const Program& program, const Samples& samples,
                                           Arithmetic arithmetic = Arithmetic::plain,
                                           std::span<const std::uint32_t> at = {});

}  // namespace rigor
