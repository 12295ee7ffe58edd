// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric 3×3 tensors that principal-moment kernels find hard, by families, with references for the exact
// doubles: for tests and benchmarks. The same on every machine.
#pragma once

#include <string>
#include <vector>

#include "numeric/body/body.h"
#include "numeric/kernels/high_low.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

struct MomentFamily {
  std::string name;
  std::vector<InertiaTensor> tensors;  // symmetric to the last bit, finite
};

/// `count` tensors a family: random bodies; gaps of two or of all moments from 1e-4 to 1e-15; integers with
/// exactly equal moments, rods and plates of integers; zero, identity, diagonal, rank one; graded moments;
/// thin rods; almost aligned axes; scales of 1e±150, 1e±300 and below the normal range; permuted and
/// reflected axes; bodies of revolution in any attitude, and spheres.
[[nodiscard]] std::vector<MomentFamily> moment_families(std::size_t count);

/// Flat and long bodies of size 1, two moments of which differ by `gap`, rounded to 106 bits.
[[nodiscard]] std::vector<SharpTensor> close_pairs(double gap, std::size_t count);

/// A random body's tensor with one NaN or infinity in the lower triangle, at each place and of each kind.
[[nodiscard]] std::vector<InertiaTensor> unusable_tensors();

using Digits50 = Decimal<50>;

struct PrincipalReference {
  std::array<Digits50, 3> moments;  // ascending
  std::array<Digits50, 3> gaps;     // I₂ − I₁, I₃ − I₂, I₃ − I₁, exactly 0 where they are
  std::array<std::array<Digits50, 3>, 3> axes;  // axes[k] is a unit eigenvector of moments[k], of either sign
};

/// Of the lower triangle. Every moment and gap has 50 digits of its own, an axis as many as its gaps leave of
/// 100. Method: Jacobi's rotations on 100 digits, on 400 where a moment or gap is below 1e-45 of the norm and
/// integer arithmetic has not proved it 0, by the discriminant or the coefficients of the characteristic
/// polynomial.
[[nodiscard]] PrincipalReference principal_reference(const InertiaTensor& tensor);

/// Of a tensor that is no tensor of doubles: a moment or gap that is exactly 0 comes out as about 1e-100.
[[nodiscard]] PrincipalReference principal_reference_of_digits(
    const std::array<std::array<Decimal<100>, 3>, 3>& tensor);

/// |computed − exact| / |exact|, less one spacing of doubles near 0 (a gap is the sum of two); where `exact`
/// is 0, |computed| / norm. Infinite for NaN, infinity and a wrong sign. `low` is added to `computed`
/// exactly.
[[nodiscard]] double relative_error(double computed, const Digits50& exact, const Digits50& norm,
                                    double low = 0);

}  // namespace rigor
