// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/stability_frequencies.h"

#include <cmath>

namespace rigor {
namespace {

/// A product whose exponent is kept apart, so that it does not leave the range on the way.
struct ScaledProduct {
  double fraction = 1;
  int exponent = 0;

  void multiply(double by) {
    int power = 0;
    fraction *= std::frexp(by, &power);
    exponent += power;
  }
  void divide(double by) {
    int power = 0;
    fraction /= std::frexp(by, &power);
    exponent -= power;
  }
  [[nodiscard]] double value() const { return std::ldexp(fraction, exponent); }
};

}  // namespace

std::array<double, 3> squared_stability_frequencies(const RoundedMoments& principal, double spin) {
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < 3; ++i) {
    ScaledProduct square;
    for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) {
      square.multiply(spin);
      square.multiply(principal.gap(i, j));
      square.divide(principal.moments[j]);
    }
    squares[i] = square.value();
  }
  return squares;
}

}  // namespace rigor
