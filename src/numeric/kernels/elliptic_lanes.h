// SPDX-License-Identifier: GPL-3.0-or-later
// Elliptic integrals and theta functions for the free rigid body. A modulus is never formed: everything is
// homogeneous in (a, b) with b/a = k', the complementary modulus, and (a, c) with c/a = k, c² = a² − b²,
// which the caller knows each to full relative accuracy. Sources: C. F. Gauss, Werke III 361; R. Bulirsch,
// Numer. Math. 7 (1965) 78; NIST Digital Library of Mathematical Functions, chapters 19, 20 and 22.
#pragma once

#include "numeric/kernels/elementary_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// M(a, b), the arithmetic-geometric mean, a ≥ b > 0: K = π a / 2 M(a, b). Relative error 1e-30.
/// Method: means until (a − b)/(a + b) = κ < 2^-26, then M = ½ (a + b) (1 − κ²/4 − 5 κ⁴/64): DLMF 19.8.
RIGOR_INLINE DoubleDouble<double> mean_of(DoubleDouble<double> a, DoubleDouble<double> b) {
  for (int level = 0; level < 16; ++level) {  // 12 suffice for b/a = 2^-1000
    const DoubleDouble<double> sum = a + b;
    const double kappa = (a - b).high / sum.high;
    if (kappa < 0x1p-26)
      return sum * 0.5 * (DoubleDouble<double>{1, 0} + -kappa * kappa * (0.25 + kappa * kappa * (5 / 64.)));
    b = root(a * b);
    a = sum * 0.5;
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
/// Relative error 1e-21. All terms are positive.
struct AmplitudeFactors {
  DoubleDouble<double> tangent;
  DoubleDouble<double> sine;
};
RIGOR_INLINE AmplitudeFactors descend(DoubleDouble<double> a, DoubleDouble<double> b,
                                      DoubleDouble<double> delta) {
  AmplitudeFactors factors{{1, 0}, {1, 0}};
  for (int level = 0; level < 16; ++level) {
    const DoubleDouble<double> mean = (a + b) * 0.5;
    const DoubleDouble<double> sum = delta + a;
    const double e = (a - mean).high;
    if (level > 0 && e < 0x1p-16 * a.high) break;
    const DoubleDouble<double> next = root((a * mean) * (delta + b) / sum);
    factors.tangent = factors.tangent * (next / a);
    factors.sine = factors.sine * (mean * 2. / sum);
    b = root(a * b);
    a = mean;
    delta = next;
  }
  // What is left differs from 1 by less than 2^-15 at first: one part is enough.
  double ah = a.high;
  double gap = (a - delta).high;
  double e = (a - b).high * 0.5;
  for (int level = 0; level < 3; ++level) {
    const double sum = 2 * ah - gap;
    const double x = e * (sum + 2 * (ah - e)) / (ah * sum);
    const double change = -x / (1 + root(1 - x));
    factors.tangent = factors.tangent + factors.tangent * change;
    factors.sine = factors.sine + factors.sine * ((gap - 2 * e) / sum);
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
