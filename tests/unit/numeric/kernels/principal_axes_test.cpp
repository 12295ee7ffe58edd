// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "numeric/kernels/solved_moments.h"

namespace rigor {
namespace {

constexpr double u = unit_roundoff;

/// Of an axis from the exact one, whichever way it points.
double distance(const Position& axis, const std::array<Digits50, 3>& exact) {
  Digits50 along = 0;
  Digits50 away = 0;
  for (std::size_t i = 0; i < 3; ++i) along += exact[i] * axis[i];
  for (std::size_t i = 0; i < 3; ++i) {
    const Digits50 d = axis[i] - (along < 0 ? -1 : 1) * exact[i];
    away += d * d;
  }
  return static_cast<double>(sqrt(away));
}

/// Jacobi's rotations in doubles, as in any textbook; axes[k] belongs to the diagonal entry k.
std::array<Position, 3> textbook_axes(InertiaTensor a, Position& moments) {
  std::array<Position, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 20; ++sweep) {
    for (const auto& [p, q] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
      if (a[p][q] == 0) continue;
      const double ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const double t = std::copysign(1, ratio) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
      const double c = 1 / std::sqrt(1 + t * t);
      const double s = c * t;
      const std::size_t r = 3 - p - q;
      const double x = a[r][p];
      a[p][p] -= t * a[p][q];
      a[q][q] += t * a[p][q];
      a[r][p] = a[p][r] = c * x - s * a[r][q];
      a[r][q] = a[q][r] = s * x + c * a[r][q];
      a[p][q] = a[q][p] = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double y = axes[p][i];
        axes[p][i] = c * y - s * axes[q][i];
        axes[q][i] = s * y + c * axes[q][i];
      }
    }
  }
  moments = {a[0][0], a[1][1], a[2][2]};
  return axes;
}

TEST_CASE("the textbook's axes are lost where moments are close") {
  for (const MomentFamily& family : moment_families(48)) {
    if (family.name.rfind("gap ", 0) != 0) continue;
    double worst = 0;
    for (const InertiaTensor& tensor : family.tensors) {
      const PrincipalReference exact = principal_reference(tensor);
      Position moments{};
      const std::array<Position, 3> axes = textbook_axes(tensor, moments);
      for (std::size_t k = 0; k < 3; ++k) {
        double least = 2;
        for (const auto& reference : exact.axes) least = std::min(least, distance(axes[k], reference));
        worst = std::max(worst, least);
      }
    }
    INFO(family.name << ": " << worst / u << " u");
    CHECK(worst > 6 * u);
  }
}

TEST_CASE("axes are good to 6 u also where moments are close, orthonormal and right-handed") {
  for (const MomentFamily& family : moment_families(96)) {
    SolvedMoments solved(family.tensors);
    solve_principal_moments(solved.columns);
    for (std::size_t at = 0; at < family.tensors.size(); ++at) {
      INFO(family.name << " " << at);
      const PrincipalReference exact = principal_reference(family.tensors[at]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Position n = solved.axis(k, at);
        const bool alone = (k == 0 || exact.gaps[k - 1] != 0) && (k == 2 || exact.gaps[k] != 0);
        if (alone) CHECK(distance(n, exact.axes[k]) <= 6 * u);
        const Position f = solved.axis((k + 1) % 3, at);
        const Position g = solved.axis((k + 2) % 3, at);
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3;
          const std::size_t l = (i + 2) % 3;
          CHECK(std::abs(n[i] - (f[j] * g[l] - f[l] * g[j])) <= 12 * u);
        }
        Digits50 length = 0;
        Digits50 product = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          length += Digits50(n[i]) * n[i];
          product += Digits50(n[i]) * f[i];
        }
        CHECK(abs(length - 1) <= 10 * u);
        CHECK(abs(product) <= 10 * u);
        if (k < 2) {
          CHECK(*std::max_element(n.begin(), n.end()) >= -*std::min_element(n.begin(), n.end()));
        }
      }
    }
  }
}

TEST_CASE("axes of moments that differ by less than the smallest number are those of different moments") {
  SharpTensor a{};
  a[0][0] = {0x1.98fe093c0d426p-1000, 0x0.000000000f322p-1022};
  a[1][0] = a[0][1] = {0x1.370083ea48a4ap-1002, -0x0.000000002ee04p-1022};
  a[1][1] = {0x1.4d8543521dad5p-1001, -0x0.00000000dab16p-1022};
  a[2][0] = a[0][2] = {-0x1.412f1432d55cdp-1000, 0x0.000000001c977p-1022};
  a[2][1] = a[1][2] = {-0x1.78e1ac041b4ddp-1002, 0x0.000000002af7ep-1022};
  a[2][2] = {0x1.0a96092b97fb6p-999, 0x0.00000000abd6p-1022};
  const PrincipalReference exact = reference_of(a);
  const auto axes = principal_axes(a);
  REQUIRE(axes);
  for (std::size_t k = 0; k < 3; ++k) {
    Digits50 along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += exact.axes[k][i] * axes->axes[k][i];
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(abs(axes->axes[k][i] - (along < 0 ? -1 : 1) * exact.axes[k][i]) <= 6 * u);
  }
}

TEST_CASE("|a n - lambda n| is at most 5 u of the norm") {
  for (const MomentFamily& family : moment_families(96)) {
    if (family.name == "scale subnormal") continue;  // moments are rounded to the last place there is
    SolvedMoments solved(family.tensors);
    solve_principal_moments(solved.columns);
    for (std::size_t at = 0; at < family.tensors.size(); ++at) {
      const InertiaTensor& a = family.tensors[at];
      for (std::size_t k = 0; k < 3; ++k) {
        const Position n = solved.axis(k, at);
        Digits50 squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          Digits50 rest = -Digits50(solved.columns.moments[k][at]) * n[i];
          for (std::size_t j = 0; j < 3; ++j) rest += Digits50(a[i][j]) * n[j];
          squares += rest * rest;
        }
        INFO(family.name << " " << at);
        CHECK(sqrt(squares) <= 5 * u * size_of(a));
      }
    }
  }
}

}  // namespace
}  // namespace rigor
