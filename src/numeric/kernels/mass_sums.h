// SPDX-License-Identifier: GPL-3.0-or-later
// Mass, centre of mass and inertia tensor of point masses, together, in one pass over the points.
//
// About a centre s, d = x − s: M = Σ m, S_i = Σ m d_i, Q_ij = Σ m d_i d_j; then c = s + S/M, and about c
// J_ij = Q_ij − S_i S_j / M, I_ij = tr(J) δ_ij − J_ij: products of inertia carry the minus.
//
// Method. s is sampled: the mean of up to 128 points spread over the array. A free shift buys what
// compensated sums would buy, because it leaves nothing to cancel: with ε_i = S_i² / (M Q_ii), the part of
// Q_ii that the move to c takes away, errors of Q grow by 1/(1 − ε_i). Sums run in 8 logical lanes, in chains
// of 8 terms and a binary tree up to 512 points, from there on in double-double, as does the move to c.
//
// Error bound (u = 2^-53, q_i = √Q_ii, e_i = √ε_i, first order). A term of Q has 2 differences and 2
// products: 4 u; a block has 7 + 3 additions one upon another: 10 u; so δQ_ij ≤ 14 u q_i q_j, by the
// Cauchy–Schwarz inequality for Σ m |d_i d_j|; in the same way δS_i ≤ 12 u √M q_i and δM ≤ 10 u M. Then, with
// k = (14, 12, 10) u,
//     δJ_ij ≤ q_i q_j (k₀ + k₁ (e_i + e_j) + k₂ e_i e_j),
// and `error` is the greatest δI_ij over the greatest I_ij, last rounding included. Where it exceeds
// `plain_error_limit`, the pass runs again about the centre that is now known, and then in double-double.
//
// Source: one-pass moments about a shift, T. F. Chan, G. H. Golub, R. J. LeVeque, Am. Stat. 37 (1983) 242.
#pragma once

#include <array>
#include <cstddef>

#include "base/result.h"
#include "numeric/kernels/high_low.h"

namespace rigor {

/// Coordinate i of point k at `position[i][stride k]`, its mass at `mass[stride k]`, kg and m. Not owned; any
/// alignment.
struct PointColumns {
  std::array<const double*, 3> position{};
  const double* mass = nullptr;
  std::size_t count = 0;
  std::size_t stride = 1;  // or 4, for records x, y, z, m one after the other
};

/// Points as records x, y, z, m of 32 bytes.
[[nodiscard]] PointColumns point_records(const double* records, std::size_t count);

struct SumOptions {
  std::size_t threads = 1;  // the result is the same to the last bit for any number
};

struct MassSums {
  double mass = 0;                 // error: 11 u
  std::array<double, 3> centre{};  // error: 13 u times the radius of gyration, and the last rounding
  std::array<std::array<double, 3>, 3> inertia{};  // about the centre of mass
  double error = 0;  // bound on the error of every entry, relative to the greatest, underflow included
  bool compensated = false;  // summed in double-double
};

/// Bound up to which plain sums are taken for good.
inline constexpr double plain_error_limit = 24 * 0x1p-53;

/// Cost: 16 operations a point, 22 without a fused multiply-add; the last bits depend on whether there is
/// one. Error: `error` ≤ 24 u where the greatest entry is above 2^-1020 and the masses are within a factor of
/// 2^1900, beyond that what underflow leaves, even infinite; 2 u was the worst over the families of
/// mass_sums_test.cpp at distances up to 1e12. A diagonal entry has that error relative to itself if the
/// sampled centre is good in its two directions, so that the least moment of a thin body along the axes keeps
/// its digits; across them it has that error relative to the greatest. Coordinates and masses of any size are
/// scaled by powers of two where sums would leave the range. Points without a mass count for nothing, however
/// far they are. Fails, naming the point (from 1), for what is not finite and for negative masses; where
/// there are no points, no mass, or a result overflows.
[[nodiscard]] Result<MassSums> mass_sums(const PointColumns& points, const SumOptions& options = {});

struct SharpMassSums {
  HighLow mass;
  SharpPosition centre{};
  SharpTensor inertia{};  // about the centre of mass
  double error = 0;  // bound on the error of every entry, relative to the greatest; infinite below 2^-900
};

/// The same as high + low. Cost: 152 operations a point where there is a fused multiply-add. Error: 2^-91
/// relative to the greatest entry at worst, where that is above 2^-900 and the masses are within a factor of
/// 2^1900, 2^-103 in the families of the test. That is 2^-93 before the move: n² u² = 2^-94 for a block's
/// compensated sums of n = 64 terms, and 3 · 2^-106 for each of 1221 chunks of 10^7 points. The move, which
/// takes away ε ≤ ¼, multiplies it by (1 + ½)² / (1 − ¼) = 3. Fails, too, where 16 passes leave the centre
/// farther from where it was taken; no such body is known.
[[nodiscard]] Result<SharpMassSums> sharp_mass_sums(const PointColumns& points,
                                                    const SumOptions& options = {});

/// The centre of mass alone, which does not overflow where the inertia does.
[[nodiscard]] Result<SharpPosition> sharp_centre_of_mass(const PointColumns& points,
                                                         const SumOptions& options = {});

}  // namespace rigor
