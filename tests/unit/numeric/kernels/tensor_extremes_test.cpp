// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors whose entries differ by hundreds of powers of ten, so that a gap or a moment is far below what the
// entries' own digits show, against Jacobi's rotations in 700 digits.
#include <algorithm>
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/jacobi_reference.h"
#include "numeric/kernels/principal_moments.h"
#include "numeric/program/uniform.h"
#include "numeric/run/run_decimal.h"

namespace rigor {
namespace {

using Digits = Decimal<700>;
constexpr double u = 0x1p-53;

/// What rotations in 700 digits leave of a 0. Entries are within 2^±220 here, and what is not 0 is above
/// 1e-500.
bool is_none(const Digits& x) { return abs(x) < Digits("1e-560"); }

double error_of(double found, const Digits& exact) {
  if (is_none(exact)) return found == 0 ? 0 : HUGE_VAL;
  if (!std::isfinite(found)) return HUGE_VAL;
  return static_cast<double>(Digits(abs((found - exact) / exact)));
}

struct Worst {
  double moment = 0;
  double gap = 0;
  double axis = 0;  // of those whose moments differ from the others
};

Worst worst_of(const InertiaTensor& tensor) {
  const auto found = principal_axes(tensor);
  REQUIRE(found);
  const JacobiReference<Digits> exact(tensor);
  const auto& moment = exact.moments;
  Worst worst;
  for (std::size_t k = 0; k < 3; ++k)
    worst.moment = std::max(worst.moment, error_of(found->principal.moments[k].high, moment[k]));
  for (std::size_t k = 0; k < 2; ++k)
    worst.gap = std::max(worst.gap, error_of(found->principal.gaps[k], moment[k + 1] - moment[k]));
  for (std::size_t k = 0; k < 3; ++k) {
    if ((k > 0 && is_none(moment[k] - moment[k - 1])) || (k < 2 && is_none(moment[k + 1] - moment[k])))
      continue;
    Digits along = 0;
    Digits away = 0;
    for (std::size_t i = 0; i < 3; ++i) along += exact.axes[k][i] * found->axes[k][i];
    for (std::size_t i = 0; i < 3; ++i) {
      const Digits d = found->axes[k][i] - (along < 0 ? -1 : 1) * exact.axes[k][i];
      away += d * d;
    }
    worst.axis = std::max(worst.axis, static_cast<double>(Digits(sqrt(away))));
  }
  return worst;
}

void check(const InertiaTensor& tensor) {
  CAPTURE(tensor[0][0], tensor[1][1], tensor[2][2]);
  INFO(std::hexfloat << tensor[0][0] << ' ' << tensor[1][1] << ' ' << tensor[2][2] << " yz " << tensor[2][1]
                     << " zx " << tensor[2][0] << " xy " << tensor[1][0]);
  const Worst worst = worst_of(tensor);
  INFO("in u: moments " << worst.moment / u << ", gaps " << worst.gap / u << ", axes " << worst.axis / u);
  CHECK(worst.moment <= 16 * u);
  CHECK(worst.gap <= 16 * u);
  CHECK(worst.axis <= 6 * u);
}

InertiaTensor tensor_of(const Position& diagonal, const Position& off) {
  InertiaTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i) {
    tensor[i][i] = diagonal[i];
    tensor[(i + 1) % 3][(i + 2) % 3] = tensor[(i + 2) % 3][(i + 1) % 3] = off[i];
  }
  return tensor;
}

TEST_CASE("a gap is 0 only where it is, however small the entries are that make it", "[moments]") {
  check(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 0}));
  check(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 1e-120}));
  check(tensor_of({0.3, 0.3, 0.3}, {1e-60, 0, 0}));
  check(tensor_of({0.3, 0.3, 0.3 + 0x1p-54}, {0, 1e-90, 1e-70}));
  const auto found = principal_moments(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 0}));
  REQUIRE(found);
  CHECK(found->gaps[0] == Approx(1e-78).epsilon(1e-9));
  CHECK(found->gaps[1] == Approx(1e-78).epsilon(1e-9));
}

TEST_CASE("axes are not exchanged for a coupling that is small beside the tensor", "[moments]") {
  check(tensor_of({26, 31, 22}, {1e-76, 0, 6}));
  check(tensor_of({26, 31, 22}, {0, -1e-76, 6}));
  check(tensor_of({26, 31, 22}, {1e-76, 1e-90, 6}));
  check(tensor_of({26, 31, 35}, {1e-140, 0, 6}));
}

TEST_CASE("a moment is 0 only where it is", "[moments]") {
  check(tensor_of({1, 1, 1}, {1, 1, 1}));
  check(tensor_of({1, 1, 1e-100}, {1e-60, 0, 1}));
  check(tensor_of({1, 0, 0}, {1e-90, 0, 0}));
  check(tensor_of({1, 1e-130, 0}, {0, 0, 0x1p-220}));
}

TEST_CASE("random tensors of entries from 1 to 1e-60, many of them equal or none, keep every promise") {
  SplitMix bits(41);
  const auto small = [&](int powers) {
    if (bits.below(4) == 0) return 0.0;
    const double size = std::pow(10, -static_cast<double>(bits.below(static_cast<std::uint64_t>(powers))));
    return uniform_sign(bits) < 0 ? -size : size * (1 + uniform(bits));
  };
  for (int n = 0; n < 25; ++n) {
    const double a = 1 + uniform(bits);
    check(tensor_of({a, a, bits.below(2) == 0 ? a : a + small(60)}, {small(60), small(60), small(60)}));
    check(tensor_of({small(60), small(60), small(60)}, {small(60), small(60), small(60)}));
    // Two moments equal but for couplings: 22 and 35 of a block, and 22 or 35.
    const double third = bits.below(2) == 0 ? 22 : 35;
    check(tensor_of({26, 31, third}, {small(60) * 1e-30, small(60), 6}));
  }
}

TEST_CASE("climbing for the worst error of moments, gaps and axes ends below their bounds", "[moments]") {
  SplitMix bits(42);
  const auto changed = [&](InertiaTensor tensor) {
    const std::size_t i = bits.below(3);
    const std::size_t j = bits.below(3);
    const double small = std::pow(10, -60 * uniform(bits)) * uniform_sign(bits);
    double entry = small;
    if (bits.below(4) == 0) entry = 0;
    if (i == j && bits.below(2) == 0) entry = tensor[(i + 1) % 3][(i + 1) % 3] + small;
    tensor[i][j] = tensor[j][i] = entry;
    return tensor;
  };
  const auto badness = [](const InertiaTensor& tensor) {
    const Worst worst = worst_of(tensor);
    INFO("in u: moments " << worst.moment / u << ", gaps " << worst.gap / u << ", axes " << worst.axis / u);
    CHECK(worst.moment <= 16 * u);
    CHECK(worst.gap <= 16 * u);
    CHECK(worst.axis <= 6 * u);
    return std::max({worst.moment / (16 * u), worst.gap / (16 * u), worst.axis / (6 * u)});
  };
  const double worst = climbed(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 0}), 60, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.05);  // so that the bounds say something
}

TEST_CASE("climbing for the worst error of an enclosed gap ends below its bound, 4 u of gaps above 2^-37",
          "[moments]") {
  SplitMix bits(43);
  const auto changed = [&](InertiaTensor tensor) {
    const std::size_t i = bits.below(3);
    const std::size_t j = bits.below(3);
    tensor[i][j] = tensor[j][i] =
        (i == j ? 1 : 0) + std::exp2(-40 * uniform(bits)) * uniform_sign(bits) * (i == j ? 0.5 : 1);
    return tensor;
  };
  const auto badness = [](const InertiaTensor& tensor) {
    const auto solved = principal_axes(tensor);
    REQUIRE(solved);
    const PrincipalMoments& found = solved->principal;
    const JacobiReference<Decimal<100>> exact(tensor);
    double worst = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      const EnclosedGap gap = found.enclosed_gap(k, k - 1);
      const Decimal<100> error = abs(exact.moments[k] - exact.moments[k - 1] - gap.value);
      CHECK(error <= gap.error);
      if (gap.value > 0x1p-37 * abs(found.moments[2].high)) CHECK(gap.error <= 4 * u * gap.value);
      worst = std::max(worst, static_cast<double>(Decimal<100>(error / gap.error)));
    }
    return worst;
  };
  const double worst = climbed(tensor_of({1, 1.5, 0.7}, {0.1, 0.2, 0.3}), 400, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.5);  // so that the bound says something
}

}  // namespace
}  // namespace rigor
