// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors whose entries differ by hundreds of powers of ten, so that a gap or a moment is far below what the
// entries' own digits show, against Jacobi's rotations in 700 digits.
#include <algorithm>
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/kernels/principal_moments.h"
#include "numeric/program/uniform.h"
#include "numeric/run/run_decimal.h"

namespace rigor {
namespace {

using Digits = Decimal<700>;
constexpr double u = 0x1p-53;

struct Diagonalised {
  std::array<std::array<Digits, 3>, 3> a;
  std::array<std::array<Digits, 3>, 3> axes;  // rows
};

Diagonalised diagonalised(const InertiaTensor& tensor) {
  Diagonalised d;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      d.a[i][j] = tensor[std::max(i, j)][std::min(i, j)];
      d.axes[i][j] = i == j ? 1 : 0;
    }
  }
  for (int sweep = 0; sweep < 14; ++sweep) {
    for (const auto& [p, q] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
      if (d.a[p][q] == 0) continue;
      const Digits tau = (d.a[q][q] - d.a[p][p]) / (2 * d.a[p][q]);
      const Digits t = (tau < 0 ? -1 : 1) / (abs(tau) + sqrt(1 + tau * tau));
      const Digits c = 1 / sqrt(1 + t * t);
      const Digits s = t * c;
      for (std::size_t k = 0; k < 3; ++k) {
        const Digits x = d.a[k][p];
        d.a[k][p] = c * x - s * d.a[k][q];
        d.a[k][q] = s * x + c * d.a[k][q];
        const Digits y = d.axes[p][k];
        d.axes[p][k] = c * y - s * d.axes[q][k];
        d.axes[q][k] = s * y + c * d.axes[q][k];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const Digits x = d.a[p][k];
        d.a[p][k] = c * x - s * d.a[q][k];
        d.a[q][k] = s * x + c * d.a[q][k];
      }
      d.a[p][q] = d.a[q][p] = 0;
    }
  }
  return d;
}

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
  const Diagonalised exact = diagonalised(tensor);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return exact.a[i][i] < exact.a[j][j]; });
  const auto moment = [&](std::size_t k) { return exact.a[order[k]][order[k]]; };
  Worst worst;
  for (std::size_t k = 0; k < 3; ++k)
    worst.moment = std::max(worst.moment, error_of(found->principal.moments[k].high, moment(k)));
  for (std::size_t k = 0; k < 2; ++k)
    worst.gap = std::max(worst.gap, error_of(found->principal.gaps[k], moment(k + 1) - moment(k)));
  for (std::size_t k = 0; k < 3; ++k) {
    if ((k > 0 && is_none(moment(k) - moment(k - 1))) || (k < 2 && is_none(moment(k + 1) - moment(k))))
      continue;
    Digits along = 0;
    Digits away = 0;
    for (std::size_t i = 0; i < 3; ++i) along += exact.axes[order[k]][i] * found->axes[k][i];
    for (std::size_t i = 0; i < 3; ++i) {
      const Digits d = found->axes[k][i] - (along < 0 ? -1 : 1) * exact.axes[order[k]][i];
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

}  // namespace
}  // namespace rigor
