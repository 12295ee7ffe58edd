// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/moment_families.h"

#include "catch.h"

namespace rigor {
namespace {

Digits50 norm_of(const InertiaTensor& tensor) {
  Digits50 sum = 0;
  for (const Position& row : tensor)
    for (const double x : row) sum += Digits50(x) * x;
  return sqrt(sum);
}

TEST_CASE("references of moments satisfy the eigenvalue equation to 45 digits, in every family") {
  for (const MomentFamily& family : moment_families(24)) {
    INFO(family.name);
    for (const InertiaTensor& tensor : family.tensors) {
      const PrincipalReference reference = principal_reference(tensor);
      const Digits50 least = norm_of(tensor) * Digits50("1e-45");
      Digits50 trace = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        trace += tensor[k][k] - reference.moments[k];
        for (std::size_t i = 0; i < 3; ++i) {
          REQUIRE(tensor[i][k] == tensor[k][i]);
          Digits50 rest = -reference.moments[k] * reference.axes[k][i];
          for (std::size_t j = 0; j < 3; ++j) rest += tensor[i][j] * reference.axes[k][j];
          REQUIRE(abs(rest) <= least);
        }
      }
      REQUIRE(abs(trace) <= least);
      REQUIRE((reference.gaps[0] >= 0 && reference.gaps[1] >= 0));
    }
  }
}

TEST_CASE("the families of moments have the gaps that they are named after") {
  for (const MomentFamily& family : moment_families(24)) {
    INFO(family.name);
    for (const InertiaTensor& tensor : family.tensors) {
      const PrincipalReference reference = principal_reference(tensor);
      const Digits50 narrow = std::min(reference.gaps[0], reference.gaps[1]);
      if (family.name.rfind("gap ", 0) == 0) {
        const Digits50 gap = narrow / reference.moments[2];
        CHECK(abs(gap - std::stod(family.name.substr(4))) < 1e-4 * std::stod(family.name.substr(4)) + 4e-16);
      }
      if (family.name == "equal integers") CHECK(narrow == 0);
      if (family.name == "integer rods, plates")
        CHECK((narrow == 0 || abs(reference.moments[0] + reference.moments[1] - reference.moments[2]) <
                                  Digits50("1e-45") * reference.moments[2]));
    }
  }
}

TEST_CASE(
    "moments that are exactly 0 or equal are so in their reference, and those that are nearly so are not") {
  const PrincipalReference rank_one = principal_reference(InertiaTensor{{{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}});
  CHECK(rank_one.moments[0] == 0);
  CHECK(rank_one.gaps[0] == 0);
  CHECK(abs(rank_one.gaps[1] - 14) < 1e-45);
  const PrincipalReference nearly =
      principal_reference(InertiaTensor{{{1, 0x1p-500, 0}, {0x1p-500, 1, 0}, {0, 0, 1}}});
  CHECK(abs(nearly.gaps[0] / Digits50(0x1p-500) - 1) < 1e-45);
  const PrincipalReference zero = principal_reference(InertiaTensor{});
  CHECK(zero.gaps[2] == 0);
  CHECK(zero.moments[2] == 0);
}

TEST_CASE("a relative error is infinite for a wrong sign and for what is no number") {
  CHECK(relative_error(1, 2, 2) == 0.5);
  CHECK(relative_error(2, 2, 2, 0x1p-60) == 0x1p-61);
  CHECK(relative_error(0x1p-60, 0, 1) == 0x1p-60);
  CHECK(std::isinf(relative_error(-1e-30, 1e-30, 1)));
  CHECK(std::isinf(relative_error(std::nan(""), 1, 1)));
  CHECK(relative_error(0, Digits50(0x1p-1074) / 4, 1) == 0);
}

TEST_CASE("tensors that no kernel can use have one number each that is not finite") {
  CHECK(unusable_tensors().size() == 18);
  for (const InertiaTensor& tensor : unusable_tensors()) {
    int bad = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) bad += std::isfinite(tensor[i][j]) ? 0 : 1;
    CHECK(bad == 1);
  }
}

}  // namespace
}  // namespace rigor
