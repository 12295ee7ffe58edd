// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/stability_frequencies.h"

namespace rigor {

std::array<double, 3> squared_stability_frequencies(const PrincipalMoments& principal, double spin) {
  const Position moments = principal.values();
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    squares[i] = (spin * (principal.gap(i, j) / moments[j])) * (spin * (principal.gap(i, k) / moments[k]));
  }
  return squares;
}

}  // namespace rigor
