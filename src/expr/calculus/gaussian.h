// SPDX-License-Identifier: GPL-3.0-or-later
// ∫ x^n e^{−ax²} dx for a > 0, from 0 or −∞ to ∞. Source: Gradshteyn and Ryzhik, 3.461; from n to n + 2 by
// parts. A test compares it with sums over small steps.
#pragma once

#include <cstdint>

namespace rigor {

/// numerator/denominator · a^{−twice/2}, times √π.
struct GaussianMoment {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  int twice = 0;
  bool root_of_pi = false;
};

inline constexpr int highest_gaussian_power = 12;

/// n from 0 to `highest_gaussian_power`.
[[nodiscard]] GaussianMoment gaussian_moment(int n, bool half_line);

}  // namespace rigor
