// SPDX-License-Identifier: GPL-3.0-or-later
// Elliptic integrals and theta functions for the free rigid body. A modulus is never formed: everything is
// homogeneous in (a, b) with b/a = k', the complementary modulus, and (a, c) with c/a = k, c² = a² − b²,
// which the caller knows each to full relative accuracy. Sources: C. F. Gauss, Werke III 361; R. Bulirsch,
// Numer. Math. 7 (1965) 78; NIST Digital Library of Mathematical Functions, chapters 19, 20 and 22.
#pragma once

#include "numeric/lane/elementary_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

using Double2 = DoubleDouble<double>;

/// a + b of like signs. Relative error 3 v, v = 2^-106. 11 operations.
RIGOR_INLINE Double2 like_sum(Double2 a, Double2 b) {
  const Double2 s = exact_sum(a.high, b.high);
  return normalised(s.high, s.low + (a.low + b.low));
}

/// a / b. Relative error 10 v.
RIGOR_INLINE Double2 quotient(Double2 a, Double2 b) {
  const double q = a.high / b.high;
  const Double2 p = exact_product(q, b.high);
  return normalised(q, (((a.high - p.high) - p.low) + (a.low - q * b.low)) / b.high);
}

/// √a, a ≥ 0. Relative error 4 v.
RIGOR_INLINE Double2 square_root(Double2 a) {
  const double r = root(a.high);
  const Double2 p = exact_product(r, r);
  return normalised(r, r > 0 ? (((a.high - p.high) - p.low) + a.low) * (0.5 / r) : 0);
}

/// √(a / b), a, b > 0: one correction of the root of the quotient in one part. Relative error 10 v.
RIGOR_INLINE Double2 root_of_quotient(Double2 a, Double2 b) {
  const double r = root(a.high / b.high);
  const Double2 p = exact_product(r, r) * b;
  return normalised(r, ((a.high - p.high) + (a.low - p.low)) * (0.5 / (r * b.high)));
}

/// M(a, b), the arithmetic-geometric mean, a ≥ b > 0: K = π a / 2 M(a, b). Relative error 1e-30.
/// Method: means until (a − b)/(a + b) = κ < 2^-26, then M = ½ (a + b) (1 − κ²/4 − 5 κ⁴/64): DLMF 19.8.
RIGOR_INLINE Double2 mean_of(Double2 a, Double2 b) {
  for (int level = 0; level < 16; ++level) {  // 12 suffice for b/a = 2^-1000
    const Double2 mean = like_sum(a, b) * 0.5;
    const double kappa = ((a.high - b.high) + (a.low - b.low)) / (2 * mean.high);
    if (kappa < 0x1p-26) {
      return normalised(mean.high,
                        mean.low - mean.high * (kappa * kappa * (0.25 + kappa * kappa * (5 / 64.))));
    }
    b = square_root(a * b);
    a = mean;
  }
  return a;
}

/// The nome from ½ (1 − √k')/(1 + √k') ≤ 0.1. Relative error 4 u. DLMF 19.5.5.
RIGOR_INLINE double nome_of(double l) {
  const double m = l * l * l * l;
  return l * (1 + m * (2 + m * (15 + m * (150 + m * (1707 + m * 20910)))));
}

/// The limits of the descending Landen transformation of (a, b) at Δ = a dn, 0 < Δ: factors of tan φ and of
/// sin φ that lead to tan v, sin v, v = π u / 2K. Also for the imaginary amplitude, where Δ > a.
///   a' = ½ (a + b), b' = √(ab), Δ'² = a a' (Δ + b)/(Δ + a); tan φ' = tan φ Δ'/a; sin φ' = sin φ 2a'/(a + Δ).
/// Relative error 1e-21, of the mean 1e-30. All terms are positive.
struct Descent {
  Double2 tangent;
  Double2 sine;
  Double2 mean;  // M(a, b)
};
RIGOR_INLINE Descent descend(Double2 a, Double2 b, Double2 delta) {
  Descent factors{{1, 0}, {1, 0}, {}};
  for (int level = 0; level < 16; ++level) {
    const Double2 mean = like_sum(a, b) * 0.5;
    const double e = ((a.high - b.high) + (a.low - b.low)) * 0.5;
    if (level > 0 && e < 0x1p-16 * a.high) break;
    const Double2 sum = like_sum(delta, a);
    const Double2 next = root_of_quotient((a * mean) * like_sum(delta, b), sum);
    factors.tangent = factors.tangent * quotient(next, a);
    factors.sine = factors.sine * quotient(mean * 2., sum);
    b = square_root(a * b);
    a = mean;
    delta = next;
  }
  factors.mean = mean_of(a, b);
  // What is left differs from 1 by less than 2^-15, then 2^-33: one part is enough.
  double ah = a.high;
  double gap = (a.high - delta.high) + (a.low - delta.low);
  double e = ((a.high - b.high) + (a.low - b.low)) * 0.5;
  for (int level = 0; level < 2; ++level) {
    const double sum = 2 * ah - gap;
    const double x = e * (sum + 2 * (ah - e)) / (ah * sum);
    const double change = -x * (0.5 + x * (0.125 + x * (0.0625 + x * (5 / 128.))));  // √(1 − x) − 1
    factors.tangent = factors.tangent + factors.tangent.high * change;
    factors.sine = factors.sine + factors.sine.high * ((gap - 2 * e) / sum);
    gap = -e - ah * change;
    ah -= e;
    e = e * e / (4 * ah);
  }
  return factors;
}

/// Coefficients of θ₃ and θ₂/(2 q^¼ cos v), polynomials in G = 2 q cos 2v, q ≤ 0.09. DLMF 20.2. What is left
/// out is below 2 q¹⁶ < 0.4 u.
RIGOR_INLINE void theta_coefficients(double q, double* theta3, double* theta2) {
  const double q2 = q * q;
  const double q4 = q2 * q2;
  const double q8 = q4 * q4;
  theta3[0] = 1 - 2 * q4;
  theta3[1] = 1 - 3 * q8;
  theta3[2] = q2;
  theta3[3] = q4 * q2;
  theta2[0] = 1 - q2 - q4 * q2 + q8 * q4;
  theta2[1] = q - q4 * q - 2 * q8 * q2 * q;
  theta2[2] = q4 - q8 * q2;
  theta2[3] = q8 * q;
}

/// The polynomial at G and at −G.
template <class T>
struct EvenOdd {
  T plus{};
  T minus{};
};
template <class T>
RIGOR_INLINE EvenOdd<T> theta_at(const double* t, T g) {
  const T square = g * g;
  const T even = t[0] + t[2] * square;
  const T odd = g * (t[1] + t[3] * square);
  return {even + odd, even - odd};
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
