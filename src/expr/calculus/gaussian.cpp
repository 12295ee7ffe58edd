// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/gaussian.h"

#include "base/check.h"

namespace rigor {

GaussianMoment gaussian_moment(int n, bool half_line) {
  RIGOR_CHECK(n >= 0 && n <= highest_gaussian_power);
  const bool odd = n % 2 != 0;
  if (odd && !half_line) return {};
  // ∫₀^∞ e^{−ax²} = √π/(2√a), ∫₀^∞ x e^{−ax²} = 1/(2a)
  GaussianMoment moment{.numerator = 1, .denominator = 2, .twice = n + 1, .root_of_pi = !odd};
  for (int k = n; k > 1; k -= 2) {
    moment.numerator *= k - 1;
    moment.denominator *= 2;
  }
  if (!half_line) moment.numerator *= 2;
  return moment;
}

}  // namespace rigor
