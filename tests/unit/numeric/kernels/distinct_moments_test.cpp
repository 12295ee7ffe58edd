// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/distinct_moments_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/moment_families.h"
#include "numeric/kernels/principal_moments.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

baseline::DistinctMoments distinct_moments_of(const InertiaTensor& tensor) {
  return baseline::distinct_moments(tensor[0].data());
}

/// What was found as high + low, over the bound of its error; the worst of moments and gaps.
double part_of_bound(const InertiaTensor& tensor, const baseline::DistinctMoments& found) {
  const PrincipalReference exact = principal_reference(tensor);
  double worst = 0;
  const auto widen = [&](const baseline::DoubleDouble<baseline::Quad>& x, int k, const Digits50& of) {
    const Digits50 error = abs(Digits50(x.high[k]) + x.low[k] - of);
    worst = std::max(worst, static_cast<double>(Digits50(error / found.error)));
  };
  for (int k = 0; k < 3; ++k) widen(found.moments, k, exact.moments[static_cast<std::size_t>(k)]);
  for (int k = 0; k < 2; ++k) widen(found.gaps, k, exact.gaps[static_cast<std::size_t>(k)]);
  return worst;
}

/// A tensor with entries of any digits: near a multiple of 1, or far from it.
InertiaTensor random_tensor(SplitMix& bits) {
  InertiaTensor tensor{};
  const double shift = std::exp2(5 * uniform(bits)) * uniform_sign(bits);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      tensor[i][j] = tensor[j][i] =
          uniform_sign(bits) * std::exp2(-12 * uniform(bits) * uniform(bits)) + (i == j ? shift : 0);
  }
  return tensor;
}

TEST_CASE("moments that lie apart are as near as their bound says") {
  SplitMix bits(51);
  std::size_t known = 0;
  for (int n = 0; n < 600; ++n) {
    const InertiaTensor tensor = random_tensor(bits);
    const auto found = distinct_moments_of(tensor);
    if (!found.known) continue;
    ++known;
    CHECK(part_of_bound(tensor, found) <= 1);
  }
  CHECK(known > 200);
}

TEST_CASE("climbing for the worst error of moments that lie apart ends below its bound", "[moments]") {
  SplitMix bits(52);
  const auto changed = [&](InertiaTensor tensor) {
    const std::size_t i = bits.below(3);
    const std::size_t j = bits.below(3);
    const double change = std::exp2(-30 * uniform(bits)) * uniform_sign(bits);
    tensor[i][j] += change;
    tensor[j][i] = tensor[i][j];
    if (bits.below(4) == 0) {
      for (std::size_t k = 0; k < 3; ++k) tensor[k][k] += change;
    }
    return tensor;
  };
  const auto badness = [](const InertiaTensor& tensor) {
    const auto found = distinct_moments_of(tensor);
    return found.known ? part_of_bound(tensor, found) : -1;
  };
  double worst = 0;
  for (int start = 0; start < 4; ++start)
    worst = std::max(
        worst, climbed(InertiaTensor{{{1, 0, 0}, {0, 1.02, 0}, {0.01, 0.002, 2}}}, 500, changed, badness));
  INFO(worst);
  CHECK(worst <= 1);
  CHECK(worst > 0x1p-8);  // so that the bound says something
}

/// With all sets of instructions; empty where they do not lie apart.
std::vector<double> rounded_results(const InertiaTensor& tensor) {
  std::vector<double> first;
  for (const LaneKernels* kernels : runnable_lane_kernels()) {
    std::vector<double> results(5);
    if (!kernels->distinct_moments(tensor[0].data(), results.data(), results.data() + 3)) results.clear();
    if (kernels == runnable_lane_kernels().front()) first = results;
    CHECK(results == first);
  }
  return first;
}

TEST_CASE("moments that lie apart, and their gaps, are the nearest doubles") {
  for (const MomentFamily& family : moment_families(96)) {
    INFO(family.name);
    std::size_t found = 0;
    for (const InertiaTensor& tensor : family.tensors) {
      const std::vector<double> results = rounded_results(tensor);
      if (results.empty()) continue;
      ++found;
      const PrincipalReference exact = principal_reference(tensor);
      for (std::size_t k = 0; k < 3; ++k) CHECK(results[k] == static_cast<double>(exact.moments[k]));
      for (std::size_t k = 0; k < 2; ++k) CHECK(results[3 + k] == static_cast<double>(exact.gaps[k]));
    }
    if (family.name == "random bodies") CHECK(found > 90);
    if (family.name.rfind("gap 1e-", 0) == 0) CHECK(found == 0);
  }
}

TEST_CASE("what is in the middle of two doubles, or is 0, is left to more careful computations") {
  const InertiaTensor tie{{{1 + 0x1p-52, 0, 0}, {0, 4, 0}, {0, 0, 8}}};  // 3 − 2^-52
  CHECK(distinct_moments_of(tie).known);
  CHECK(rounded_results(tie).empty());
  CHECK(principal_moments(tie)->gaps == std::array<double, 2>{3, 4});
  const InertiaTensor plate{{{1, 2, 0}, {2, 4, 0}, {0, 0, 3}}};
  CHECK(distinct_moments_of(plate).known);
  CHECK(rounded_results(plate).empty());
  CHECK(principal_moments(plate)->moments[0] == 0);
}

TEST_CASE("moments of tensors far from 1 in size are left to more careful computations") {
  for (const int power : {-600, -250, 250, 600}) {
    InertiaTensor tensor{{{1, 0.1, 0.2}, {0.1, 2, 0.3}, {0.2, 0.3, 3}}};
    CHECK_FALSE(rounded_results(tensor).empty());
    for (Position& row : tensor)
      for (double& entry : row) entry = std::ldexp(entry, power);
    CHECK(rounded_results(tensor).empty());
  }
  for (const InertiaTensor& tensor : unusable_tensors()) CHECK(rounded_results(tensor).empty());
}

}  // namespace
}  // namespace rigor
