// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/stability_frequencies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/kernels/moment_families.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

/// The worst relative error over the axes, in u, for ω = 0.7 rad/s.
double worst_error(const InertiaTensor& tensor, const std::array<double, 3>& squares) {
  const PrincipalReference exact = principal_reference(tensor);
  const auto gap = [&](std::size_t i, std::size_t j) {
    const Digits50 size = i + j == 1 ? exact.gaps[0] : i + j == 3 ? exact.gaps[1] : exact.gaps[2];
    return i > j ? size : Digits50(-size);
  };
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Digits50 square =
        Digits50(0.7) * 0.7 * gap(i, j) * gap(i, k) / (exact.moments[j] * exact.moments[k]);
    worst = std::max(worst, relative_error(squares[i], square, 1) / u);
  }
  return worst;
}

bool has_frequencies(const MomentFamily& family) {
  return family.name != "integer rods, plates" && family.name != "0, 1, diagonal, rank 1" &&
         family.name != "scale subnormal";
}

TEST_CASE("stability frequencies are good to 40 u of themselves, however close the moments are") {
  for (const MomentFamily& family : moment_families(48)) {
    if (!has_frequencies(family)) continue;
    INFO(family.name);
    for (const InertiaTensor& tensor : family.tensors) {
      const auto principal = principal_moments(tensor);
      if (principal->moments[0] < std::numeric_limits<double>::min()) continue;
      CHECK(worst_error(tensor, squared_stability_frequencies(*principal, 0.7)) <= 40);
    }
  }
}

TEST_CASE("with differences of correctly rounded moments they miss that bound where moments are close") {
  for (const MomentFamily& family : moment_families(48)) {
    if (family.name.rfind("gap ", 0) != 0 && family.name != "nearly equal") continue;
    INFO(family.name);
    double worst = 0;
    for (const InertiaTensor& tensor : family.tensors) {
      RoundedMoments rounded = *principal_moments(tensor);
      for (std::size_t k = 0; k < 2; ++k) rounded.gaps[k] = rounded.moments[k + 1] - rounded.moments[k];
      worst = std::max(worst, worst_error(tensor, squared_stability_frequencies(rounded, 0.7)));
    }
    CHECK(worst > 40);
  }
}

TEST_CASE("a racket is stable about the axes of its least and greatest moments alone") {
  const auto squares =
      squared_stability_frequencies(*principal_moments(InertiaTensor{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}), 2);
  CHECK(squares == std::array<double, 3>{4. * 1 * 2 / 6, -4. / 3, 4. * 2 * 1 / 2});
}

TEST_CASE("neither huge nor tiny moments overflow in a frequency, and a thin rod has none about itself") {
  for (const double scale : {1e-300, 1e300}) {
    const InertiaTensor tensor{{{scale, 0, 0}, {0, 2 * scale, 0}, {0, 0, 3 * scale}}};
    CHECK(std::abs(squared_stability_frequencies(*principal_moments(tensor), 1)[0] - 1. / 3) <= 4 * u);
  }
  const InertiaTensor needle{{{1e-300, 0, 0}, {0, 1, 0}, {0, 0, 1 + 0x1p-40}}};
  const double square = squared_stability_frequencies(*principal_moments(needle), 1e10)[2];
  CHECK(std::abs(square / (1e20 * 0x1p-40 / 1e-300 * (1 + 0x1p-40)) - 1) <= 8 * u);
  const InertiaTensor thinner{{{1e-310, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  CHECK(squared_stability_frequencies(*principal_moments(thinner), 1) == std::array<double, 3>{1, 0, 0});
  const auto rod =
      squared_stability_frequencies(*principal_moments(InertiaTensor{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}), 1);
  CHECK(rod[0] == 1);
  CHECK(std::isnan(rod[1]));
}

}  // namespace
}  // namespace rigor
