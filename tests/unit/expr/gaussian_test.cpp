// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/gaussian.h"

#include <cmath>

#include "catch.h"

namespace rigor {
namespace {

double value(const GaussianMoment& moment, double a) {
  const double root = moment.root_of_pi ? std::sqrt(std::acos(-1.0)) : 1;
  return static_cast<double>(moment.numerator) / static_cast<double>(moment.denominator) * root *
         std::pow(a, -0.5 * moment.twice);
}

/// The sum over small steps: of a Gaussian its error falls faster than any power of the step; on the half
/// line Simpson's rule has one of order step^4.
double summed(int n, double a, bool half_line) {
  constexpr int steps = 20'000;
  const double end = 12 / std::sqrt(a);
  const double begin = half_line ? 0 : -end;
  const double step = (end - begin) / steps;
  double total = 0;
  for (int k = 0; k <= steps; ++k) {
    const double x = begin + k * step;
    const double weight = k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
    total += weight * std::pow(x, n) * std::exp(-a * x * x);
  }
  return total * step / 3;
}

TEST_CASE("moments of a Gaussian are what sums over small steps give") {
  for (int n = 0; n <= highest_gaussian_power; ++n) {
    for (const double a : {0.3, 1.0, 2.5}) {
      for (const bool half_line : {false, true}) {
        CAPTURE(n, a, half_line);
        const double expected = summed(n, a, half_line);
        const double scale = summed(n, a, true);
        CHECK(std::abs(value(gaussian_moment(n, half_line), a) - expected) <= 1e-9 * scale);
      }
    }
  }
}

}  // namespace
}  // namespace rigor
