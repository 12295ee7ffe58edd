// SPDX-License-Identifier: GPL-3.0-or-later
// The set-up of torque_free.h, in two parts throughout, so that what grows with the time (rate, period) is
// known to 1e-28 and what does not (the phase at the time 0) to 1e-21.
//
// With d₁ = |J₃ − J₂|, d₂ = |J₃ − J₁|, d₃ = |J₂ − J₁| Euler's equations keep
//   P₁ = |L² − 2T J₁| = J₂ d₃ ω₂² + J₃ d₂ ω₃²,   P₃ = |2T J₃ − L²| = J₁ d₂ ω₁² + J₂ d₁ ω₂²,
//   D  = |L² − 2T J₂| = J₃ d₁ ω₃² − J₁ d₃ ω₁² ≥ 0, which selects axis 3; D = 0 on the separatrix.
//   a² = d₁ P₁ / J₁J₂J₃,  b² = d₂ D / J₁J₂J₃,  c² = d₃ P₃ / J₁J₂J₃ = a² − b²;  u' = ±a, + where J₃ is
//   greatest, ω₁² = P₃/(J₁ d₂) cn² u,  ω₂² = P₃/(J₂ d₁) sn² u,  ω₃² = P₁/(J₃ d₂) dn² u,  k' = b/a.
#pragma once

#include "numeric/lane/elliptic_lanes.h"
#include "numeric/lane/exact_terms.h"
#include "numeric/lane/free_bodies.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// Moments and spin in the standard frame, with what Euler's equations keep.
struct StandardFrame {
  double moment[3] = {};
  double spin[3] = {};
  Double2 gap[3] = {};  // d₁, d₂, d₃: exact
  Double2 p1;           // over scale1²
  Double2 p3;           // over scale3²
  Double2 d;            // over scale²
  double scale = 0;     // powers of two, so that no square underflows that has a gap
  double scale1 = 0;
  double scale3 = 0;
  double direction = 0;  // of u: +1 where J₃ is greatest
};

/// a b c², 0 where b is, however large c.
RIGOR_INLINE Double2 product(double a, Double2 b, double c) {
  return b.high == 0 ? Double2{} : (b * a) * exact_product(c, c);
}

RIGOR_INLINE double power_below_largest(double a, double b) {
  return greater(power_below(greater(absolute(a), absolute(b))), 0x1p-1022);
}

/// I₃ d₁ ω₃² − I₁ d₃ ω₁² in the order of the moments; exactly where it nearly vanishes.
RIGOR_INLINE Double2 separatrix_distance(double high, Double2 to_high, double spin_high, double low,
                                         Double2 to_low, double spin_low) {
  const Double2 one = product(high, to_high, spin_high);
  const Double2 other = product(low, to_low, spin_low);
  const Double2 d = one - other;
  if (absolute(d.high) > 0x1p-10 * one.high) return d;
  ExactTerms terms;
  terms.add_product(high, to_high, exact_product(spin_high, spin_high), 1);
  terms.add_product(low, to_low, exact_product(spin_low, spin_low), -1);
  return terms.value();
}

/// False: the spin is steady.
RIGOR_INLINE bool standard_frame(const double* moments, const double* spin, FreeSpin& out,
                                 StandardFrame& frame) {
  int order[3] = {0, 1, 2};  // by moment
  double parity = 1;
  for (int i = 0; i < 3; ++i) {  // three exchanges of neighbours sort three
    const int k = i == 1 ? 1 : 0;
    if (moments[order[k]] <= moments[order[k + 1]]) continue;
    const int swap = order[k];
    order[k] = order[k + 1];
    order[k + 1] = swap;
    parity = -parity;
  }
  const auto [low, middle, high] = order;
  const Double2 to_high = exact_difference(moments[high], moments[middle]);
  const Double2 to_low = exact_difference(moments[middle], moments[low]);
  const Double2 across = exact_difference(moments[high], moments[low]);
  const bool moves[3] = {to_high.high != 0 && spin[middle] != 0 && spin[high] != 0,
                         across.high != 0 && spin[high] != 0 && spin[low] != 0,
                         to_low.high != 0 && spin[low] != 0 && spin[middle] != 0};
  if (!(moves[0] || moves[1] || moves[2])) return false;

  frame.scale = power_below_largest(to_high.high == 0 ? 0 : spin[high], to_low.high == 0 ? 0 : spin[low]);
  frame.d = separatrix_distance(moments[high], to_high, spin[high] / frame.scale, moments[low], to_low,
                                spin[low] / frame.scale);
  const bool about_high = frame.d.high >= 0;
  frame.direction = about_high ? 1 : -1;
  if (!about_high) frame.d = -frame.d;
  out.axis[0] = about_high ? low : high;
  out.axis[1] = middle;
  out.axis[2] = about_high ? high : low;
  frame.gap[0] = about_high ? to_high : to_low;
  frame.gap[1] = across;
  frame.gap[2] = about_high ? to_low : to_high;
  out.sign[1] = 1;
  out.sign[2] = spin[out.axis[2]] < 0 ? -1 : 1;
  out.sign[0] = parity * frame.direction * out.sign[2];
  if (spin[out.axis[0]] * out.sign[0] < 0) {
    out.sign[0] = -out.sign[0];
    out.sign[1] = -1;
  }
  for (int i = 0; i < 3; ++i) {
    frame.moment[i] = moments[out.axis[i]];
    frame.spin[i] = spin[out.axis[i]] * out.sign[i];
  }
  const auto& [j1, j2, j3] = frame.moment;
  const auto& [w1, w2, w3] = frame.spin;
  frame.scale1 = power_below_largest(frame.gap[2].high == 0 ? 0 : w2, w3);
  frame.scale3 = power_below_largest(w1, w2);
  const double inverse1 = 1 / frame.scale1;
  const double inverse3 = 1 / frame.scale3;
  frame.p1 = like_sum(product(j2, frame.gap[2], w2 * inverse1), product(j3, across, w3 * inverse1));
  frame.p3 = like_sum(product(j1, across, w1 * inverse3), product(j2, frame.gap[0], w2 * inverse3));
  return true;
}

/// a and b in units of `unit` `scale1` (J₁J₂J₃)^-½, a power of two with which 1 ≤ a < 2: however slowly a top
/// precesses, no product of theirs underflows.
struct Moduli {
  Double2 a;
  Double2 b;
  double unit = 0;
};
RIGOR_INLINE Moduli moduli_of(const StandardFrame& frame) {
  const Double2 a = square_root(frame.gap[0] * frame.p1);
  const double unit = power_below(a.high);
  const double inverse = 1 / unit;
  return {a * inverse, square_root(frame.gap[1] * frame.d) * (frame.scale / frame.scale1) * inverse, unit};
}
/// c in the same unit.
RIGOR_INLINE Double2 third_modulus(const StandardFrame& frame, const Moduli& m) {
  return square_root(frame.gap[2] * frame.p3) * (frame.scale3 / frame.scale1) * (1 / m.unit);
}
/// a dn u = √(d₁d₂J₃) ω₃ at the time 0, in the same unit.
RIGOR_INLINE Double2 first_delta(const StandardFrame& frame, const Moduli& m) {
  return square_root(frame.gap[0] * frame.gap[1] * frame.moment[2]) * (frame.spin[2] / frame.scale1) *
         (1 / m.unit);
}

RIGOR_INLINE void set_two(double* into, Double2 from) {
  into[0] = from.high;
  into[1] = from.low;
}

/// The nome of (a, b), c² = a² − b² given, from one step down, where it is q². Relative error 4 u.
RIGOR_INLINE double circular_nome(double a, double b, double c_square) {
  const double a1 = (a + b) / 2;
  const double b1 = root(a * b);
  const double c1 = c_square / (4 * a1);
  const double r = a1 + root(a1 * b1);
  return root(nome_of(c1 * c1 * a1 / (2 * (a1 + b1) * r * r)));
}

RIGOR_INLINE void set_circular(const StandardFrame& frame, const Moduli& m, Double2 root_product,
                               FreeSpin& out) {
  const auto& [j1, j2, j3] = frame.moment;
  const auto& [w1, w2, w3] = frame.spin;
  const double c = third_modulus(frame, m).high;
  out.kind = FreeSpinKind::circular;
  out.nome = circular_nome(m.a.high, m.b.high, c * c);
  const Descent descent = descend(m.a, m.b, first_delta(frame, m));
  const Double2 rate = quotient(descent.mean, root_product) * inverse_pi * frame.direction;
  set_two(out.rate, rate * m.unit * frame.scale1);
  // tan φ at the time 0, both parts times √(J₁ d₂).
  const Double2 x = frame.gap[1] * j1;
  const Double2 y = square_root(frame.gap[0] * j2 * x) * descent.tangent;
  set_two(out.start, half_turns_of(x * (w1 / frame.scale3), y * (w2 / frame.scale3)));
}

RIGOR_INLINE void set_hyperbolic(const StandardFrame& frame, const Moduli& m, Double2 root_product,
                                 FreeSpin& out) {
  const auto& [j1, j2, j3] = frame.moment;
  const auto& [w1, w2, w3] = frame.spin;
  const Double2 c = third_modulus(frame, m);
  const double ac = (m.a.high + c.high) * m.a.high;
  const double root_l = m.b.high / (root(2 * ac) * (1 + root(c.high / m.a.high)));
  const double l2 = root_l * root_l;
  const double l8 = l2 * l2 * l2 * l2;
  out.kind = FreeSpinKind::hyperbolic;
  out.nome = nome_of(l2);
  out.root_nome = root_l * root(1 + l8 * (2 + l8 * (15 + l8 * 150)));
  // cn u : sn u : 1 = x : y : r at the time 0. From u or from K − u, whichever is less.
  const Double2 x = square_root(frame.gap[1] * j1) * (w1 / frame.scale3);
  const Double2 y = square_root(frame.gap[0] * j2) * (absolute(w2) / frame.scale3);
  const Double2 r = square_root(frame.p3);
  const bool near = m.b.high == 0 || y.high * y.high * m.b.high <= x.high * x.high * m.a.high;
  const Double2 delta = near ? quotient(first_delta(frame, m) * r, x) : quotient(m.a * r, y);
  const Descent descent = descend(m.a, c, delta);
  const Double2 sine = (near ? quotient(y, x) : quotient(x * m.a, y * m.b)) * descent.sine;
  Double2 start = logarithm(sine.high < 0x1p400 ? sine + square_root(sine * sine + 1.) : sine * 2.);
  set_two(out.rate, quotient(descent.mean, root_product) * frame.direction * m.unit * frame.scale1);
  if (m.b.high != 0) {
    const Double2 half = quotient(descent.mean * Double2{pi_high, pi_low}, mean_of(m.a, m.b));
    set_two(out.half_period, half);
    out.inverse_half_period = 1 / half.high;
    if (!near) start = half * 0.5 - start;
  }
  set_two(out.start, w2 < 0 ? -start : start);
}

/// The amplitudes of ω over `scale`, with the constants of the theta functions.
RIGOR_INLINE void set_amplitudes(const StandardFrame& frame, FreeSpin& out) {
  const auto& [j1, j2, j3] = frame.moment;
  theta_coefficients(out.nome, out.theta3, out.theta2);
  const EvenOdd<double> theta3 = theta_at(out.theta3, 2 * out.nome);
  const double theta2 = theta_at(out.theta2, 2 * out.nome).plus;
  const double size1 = frame.scale3 * root(frame.p3.high / (j1 * frame.gap[1].high));
  const double size2 = frame.scale3 * root(frame.p3.high / (j2 * frame.gap[0].high));
  const double size3 = frame.scale1 * root(frame.p1.high / (j3 * frame.gap[1].high));
  const bool circular = out.kind == FreeSpinKind::circular;
  out.amplitude[0] = size1 * (circular ? theta3.minus / theta2 : theta2 / theta3.minus);
  out.amplitude[1] = size2 * (theta3.plus / (circular ? theta2 : theta3.minus));
  out.amplitude[2] = size3 * ((circular ? theta3.minus : theta2) / theta3.plus);
  for (int i = 0; i < 3; ++i) out.amplitude[i] *= out.sign[i];
}

/// The largest of three, as a power of two; at least 2^-1000, and 0 for zeros.
RIGOR_INLINE double size_of(const double* v) {
  const double largest = greater(greater(absolute(v[0]), absolute(v[1])), absolute(v[2]));
  return largest > 0x1p-1000 || largest == 0 ? power_below(largest) : 0x1p-1000;
}

/// Amplitudes in rad/s.
RIGOR_INLINE void apply_scale(FreeSpin& out) {
  for (double& amplitude : out.amplitude) amplitude *= out.scale;
}

/// Moments and spin are finite, moments positive and within 2^200 of each other. Leaves the amplitudes over
/// `scale`.
RIGOR_INLINE void set_free_spin(const double* moments, const double* spin, FreeSpin& out,
                                StandardFrame& frame) {
  for (int i = 0; i < 3; ++i) out.spin[i] = spin[i];
  out.scale = size_of(spin);
  if (out.scale == 0) return;
  const double per_moment = 1 / size_of(moments);
  const double per_spin = 1 / out.scale;
  double scaled_moments[3];
  double scaled_spin[3];
  for (int i = 0; i < 3; ++i) {
    scaled_moments[i] = moments[i] * per_moment;
    scaled_spin[i] = spin[i] * per_spin;
  }
  if (!standard_frame(scaled_moments, scaled_spin, out, frame)) return;
  const Moduli m = moduli_of(frame);
  const Double2 root_product = square_root(exact_product(frame.moment[0], frame.moment[1]) * frame.moment[2]);
  if (m.b.high >= m.a.high / 2) {
    set_circular(frame, m, root_product, out);
  } else {
    set_hyperbolic(frame, m, root_product, out);
  }
  set_amplitudes(frame, out);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
