// SPDX-License-Identifier: GPL-3.0-or-later
// One step of many free bodies, each with its own moments, spin and time: torque_free_step.h. No lane
// branches, no moments are sorted but the greatest, I₃, and nothing is singular: tops, spheres, rest and the
// separatrix are like all others.
//
// With m = Iω/L the spin is ω = L m/I₃ + (a m₁, b m₂, 0), a = L (I₃ − I₁)/I₁I₃ ≥ 0, b = L (I₃ − I₂)/I₂I₃ ≥ 0,
// and E = a m₁² + b m₂² is kept. With r = (aE, bE, ab) ≥ 0, in none of which anything cancels,
//
//   v'² = (1 − r₁v²)(1 − r₂v²)(1 − r₃v²), v ~ t,  u = v²,  cᵢ = √(1 − rᵢu),  D = 1 − ab (m₁² + m₂²) u,
//   ωᵢ(t) = [ωᵢ cⱼcₖ + (Iⱼ − Iₖ)/Iᵢ v cᵢ ωⱼωₖ]/D,
//   χ(t) = L t/I₃ + abE ∫₀ᵗ u dt + 2 arg((1 + c₁)(1 + c₂) + i E v (1 + c₃)),
//
// and the attitude is the shortest turn of m(t) to m(0), then one by χ about m(0). The first is the addition
// theorem of ℘, of which 1/u is the difference from its value at the pole of an integral of the third kind;
// the second is the addition theorem of that integral, and χ depends on the constants and the time alone. A
// quarter of the time needs few terms of series. It is doubled twice, by
//
//   n = (1 − s₂u²)² + 4 s₃u³ (2 − s₁u),  sₖ the elementary symmetric polynomials of r,
//   u(2t) = 4u c₁²c₂²c₃²/n,  cᵢ(2t) = (cᵢ²cⱼ² + cᵢ²cₖ² − cⱼ²cₖ²)/√n,
//   abE ∫₀²ᵗ u = 2 abE ∫₀ᵗ u + arg(1 − s₂u² + 2 s₃u³ + 2i abE u v c₁c₂c₃),
//   (cⱼcₖ − D)(2t) = 2u cᵢ² (cⱼ²cₖ² xᵢ − cᵢ² yᵢ² u)/n,  with p = (a (b − a) m₁², b (a − b) m₂², ab m₃²),
//   x = (p₂ − p₃, p₁ − p₃, p₁ + p₂),  y = (p₂ + p₃, p₁ + p₃, p₂ − p₁).
//
// The last line gives what is added to ωᵢ without cancellation, exactly 0 where the spin is steady. Errors
// that are the same in every step are then as small as the change; those of the size of ωᵢ would let L and
// the energy drift by 3 u in each.
//
// Sources: DLMF 23.3, 23.9, 23.10; C. G. J. Jacobi, J. reine angew. Math. 39 (1850) 293; E. Celledoni, F.
// Fassò, N. Säfström, A. Zanna, SIAM J. Sci. Comput. 30 (2008) 2084. The formula of χ is worked out here, and
// torque_free_step_test.cpp compares it with Taylor series in 70 digits.
#pragma once

#include "numeric/lane/elementary_lanes.h"
#include "numeric/lane/free_attitude_lanes.h"
#include "numeric/lane/free_bodies.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// The series serve where s₁ of a quarter of the step is at most this: in the whole step no cᵢ comes to 0.
inline constexpr double most_quarter_sum = 1 / 16.;
/// A quarter of L t/I₃; for `small_sine_cosine`.
inline constexpr double most_quarter_turn = 0.375;

/// Components with the axis of the greatest moment last, a cyclic exchange.
template <class T>
struct GreatestLast {
  Mask<T> third{};  // is last already
  Mask<T> first{};  // else

  RIGOR_INLINE explicit GreatestLast(const T* moment)
      : third((moment[2] >= moment[0]) & (moment[2] >= moment[1])), first(moment[0] >= moment[1]) {}
  RIGOR_INLINE void exchange(const T* from, T* into) const {
    for (int i = 0; i < 3; ++i)
      into[i] = select(third, from[i], select(first, from[(i + 1) % 3], from[(i + 2) % 3]));
  }
  RIGOR_INLINE void restore(const T* from, T* into) const {
    for (int i = 0; i < 3; ++i)
      into[i] = select(third, from[i], select(first, from[(i + 2) % 3], from[(i + 1) % 3]));
  }
};

/// The symmetric functions of r.
template <class T>
struct PhaseConstants {
  T r[3];
  T s1;
  T s2;
  T s3;

  RIGOR_INLINE PhaseConstants(T a, T b, T e) : r{a * e, b * e, a * b} {
    s1 = r[0] + r[1] + r[2];
    s2 = r[0] * r[1] + r[2] * (r[0] + r[1]);
    s3 = r[0] * r[1] * r[2];
  }
};

/// u and ∫u at the time 1, s₁ ≤ 1/16. 1/u = ℘ + s₁/3 by Laurent's series of ℘ to its term t¹⁴ (DLMF 23.9.2;
/// what is left out is below 0.01 u), its reciprocal integrated to the term t¹⁷ (below 4e-15 of itself, which
/// is at most 1e-3 of the turn).
template <class T>
struct Phase {
  T u{};
  T integral{};
};
template <class T>
RIGOR_INLINE Phase<T> quarter_phase(const PhaseConstants<T>& k) {
  const T p1 = k.s1 * (1 / 3.);
  const T square = k.s1 * k.s1;
  const T c2 = square * (1 / 15.) - k.s2 * (1 / 5.);
  const T c3 = (k.s3 - k.s1 * k.s2 * (1 / 3.) + square * k.s1 * (2 / 27.)) * (1 / 7.);
  const T c4 = c2 * c2 * (1 / 3.);
  const T c5 = c2 * c3 * (3 / 11.);
  const T c6 = (2. * c2 * c4 + c3 * c3) * (1 / 13.);
  const T c7 = (c2 * c5 + c3 * c4) * (1 / 10.);
  const T c8 = (2. * (c2 * c6 + c3 * c5) + c4 * c4) * (3 / 85.);
  const T d1 = -p1;
  const T d2 = -(p1 * d1 + c2);
  const T d3 = -(p1 * d2 + c2 * d1 + c3);
  const T d4 = -((p1 * d3 + c2 * d2) + (c3 * d1 + c4));
  const T d5 = -((p1 * d4 + c2 * d3) + (c3 * d2 + c4 * d1) + c5);
  const T d6 = -((p1 * d5 + c2 * d4) + (c3 * d3 + c4 * d2) + (c5 * d1 + c6));
  const T d7 = -((p1 * d6 + c2 * d5) + (c3 * d4 + c4 * d3) + (c5 * d2 + c6 * d1));
  const T tail = ((d7 * (1 / 17.) + d6 * (1 / 15.)) + d5 * (1 / 13.)) + d4 * (1 / 11.);
  return {1 / (1 + (p1 + (c2 + (c3 + (c4 + (c5 + (c6 + (c7 + c8)))))))),
          1 / 3. + (d1 * (1 / 5.) + (d2 * (1 / 7.) + (d3 * (1 / 9.) + tail)))};
}

/// From t to 2t, over powers of √n.
template <class T>
struct Doubled {
  T before{};     // u at t
  T square[3]{};  // cᵢ² at t
  T pair[3]{};    // cⱼ²cₖ² at t
  T n{};
  T u{};                    // times n
  T v{};                    // times √n
  T c[3]{};                 // times √n
  ComplexNumber<T> turn{};  // of length √n
};
template <class T>
RIGOR_INLINE Doubled<T> doubled(const PhaseConstants<T>& k, T abe, T u) {
  Doubled<T> next;
  next.before = u;
  for (int i = 0; i < 3; ++i) next.square[i] = 1 - k.r[i] * u;
  for (int i = 0; i < 3; ++i) next.pair[i] = next.square[(i + 1) % 3] * next.square[(i + 2) % 3];
  for (int i = 0; i < 3; ++i)
    next.c[i] = next.square[i] * (next.square[(i + 1) % 3] + next.square[(i + 2) % 3]) - next.pair[i];
  const T product = u * (next.square[0] * next.pair[0]);
  const T u2 = u * u;
  const T cube = k.s3 * (u2 * u);
  const T even = 1 - k.s2 * u2;
  next.u = 4. * product;
  next.v = 2. * root(product);
  next.n = even * even + 4. * cube * (2 - k.s1 * u);
  next.turn = {even + 2. * cube, abe * u * next.v};
  return next;
}

template <class T>
RIGOR_INLINE T greatest_of(const T* v) {
  return greater(greater(absolute(v[0]), absolute(v[1])), absolute(v[2]));
}
/// Has this power of two an inverse, and some room?
template <class T>
RIGOR_INLINE Mask<T> is_moderate(T x) {
  return (x >= 0x1p-1000) & (x <= 0x1p1000);
}

/// One body in each lane, in the order of `GreatestLast`; units of moment and spin are powers of two, the
/// unit of time is a quarter of the step.
template <class T>
struct FreeState {
  T moment[3]{};
  T spin[3]{};
  T m[3]{};
  T m2[3]{};         // squares
  T per_momentum{};  // 1/L; 1 at rest
  T time{};          // a quarter of the step in units of 1/spin
  T per_moments{};   // 1/I₁I₂I₃
  T mean{};          // L/I₃
  T a{};
  T b{};
  T e{};
  Mask<T> is_served{};
};
template <class T>
RIGOR_INLINE FreeState<T> free_state(const T* moment, T moment_unit, const T* spin, T spin_unit, T time) {
  FreeState<T> s;
  T l[3];
  T l2[3];
  for (int i = 0; i < 3; ++i) {
    s.moment[i] = moment[i] * inverse_power(moment_unit);
    s.spin[i] = spin[i] * inverse_power(spin_unit);
    l[i] = s.moment[i] * s.spin[i];
    l2[i] = l[i] * l[i];
  }
  const T momentum = root(l2[0] + l2[1] + l2[2]);
  s.per_momentum = 1 / select(momentum > 0, momentum, all<T>(1));
  for (int i = 0; i < 3; ++i) {
    s.m[i] = l[i] * s.per_momentum;
    s.m2[i] = l2[i] * (s.per_momentum * s.per_momentum);
  }
  const auto& [j1, j2, j3] = s.moment;
  s.time = time * spin_unit * 0.25;
  s.per_moments = 1 / (j1 * j2 * j3);
  const T per_moments = momentum * s.time * s.per_moments;
  s.a = per_moments * (j2 * (j3 - j1));
  s.b = per_moments * (j1 * (j3 - j2));
  s.mean = per_moments * (j1 * j2);
  s.e = s.a * s.m2[0] + s.b * s.m2[1];
  s.is_served = (select(j1 < j2, j1, j2) >= 0x1p-200) & is_moderate(moment_unit) & is_moderate(spin_unit) &
                (absolute(s.mean) <= most_quarter_turn);
  return s;
}

/// After the step.
template <class T>
RIGOR_INLINE void next_spin(const FreeState<T>& s, const Doubled<T>& whole, T* next) {
  const T ab = s.a * s.b;
  const T p1 = s.a * (s.b - s.a) * s.m2[0];
  const T p2 = s.b * (s.a - s.b) * s.m2[1];
  const T p3 = ab * s.m2[2];
  const T x[3] = {p2 - p3, p1 - p3, p1 + p2};
  const T y[3] = {p2 + p3, p1 + p3, p2 - p1};
  const T per_d = 1 / (whole.n - ab * (s.m2[0] + s.m2[1]) * whole.u);
  const T factor = s.time * whole.v * s.per_moments;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const T own = 2. * whole.before * whole.square[i] *
                  (whole.pair[i] * x[i] - whole.square[i] * (y[i] * y[i] * whole.before));
    const T other = (s.moment[j] - s.moment[k]) * (s.moment[j] * s.moment[k]) * (s.spin[j] * s.spin[k]);
    next[i] = s.spin[i] + (s.spin[i] * own + other * factor * whole.c[i]) * per_d;
  }
}

/// e^{iχ/2} but for its length.
template <class T>
RIGOR_INLINE ComplexNumber<T> half_twist(const FreeState<T>& s, T linear, const Doubled<T>& half,
                                         const Doubled<T>& whole) {
  const SineCosine<T> start = small_sine_cosine(DoubleDouble<T>{2. * linear, T{}});
  const T n = root(whole.n);
  return ComplexNumber<T>{start.cosine, start.sine} * half.turn *
         ComplexNumber<T>{n + whole.turn.real, whole.turn.imaginary} *
         ComplexNumber<T>{(n + whole.c[0]) * (n + whole.c[1]), s.e * whole.v * (n + whole.c[2])};
}

/// A step of one body in each lane. `beyond`: too long a step, or no such body; its results mean nothing.
template <class T>
struct FreeStep {
  T spin[3]{};
  Turn<T> turn{};  // of any length
  Mask<T> beyond{};
};
template <class T>
RIGOR_INLINE FreeStep<T> free_step(const T* moment, const T* spin, T time) {
  const GreatestLast<T> order(moment);
  const T spin_unit = power_below(greater(greatest_of(spin), all<T>(0x1p-1000)));
  T moments[3];
  T spins[3];
  order.exchange(moment, moments);
  order.exchange(spin, spins);
  const FreeState<T> s = free_state(moments, power_below(greatest_of(moment)), spins, spin_unit, time);
  const PhaseConstants<T> k(s.a, s.b, s.e);
  const T abe = k.r[2] * s.e;
  const Phase<T> quarter = quarter_phase(k);
  const Doubled<T> half = doubled(k, abe, quarter.u);
  const Doubled<T> whole = doubled(k, abe, half.u / half.n);
  FreeStep<T> step;
  step.beyond = negation(s.is_served & (k.s1 <= most_quarter_sum));

  T next[3];
  next_spin(s, whole, next);
  order.restore(next, step.spin);
  for (int i = 0; i < 3; ++i) step.spin[i] = step.spin[i] * spin_unit;

  const ComplexNumber<T> twist = half_twist(s, s.mean + abe * quarter.integral, half, whole);
  T m[3];
  for (int i = 0; i < 3; ++i) m[i] = s.moment[i] * next[i] * s.per_momentum;
  T vector[3];
  T turn[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int l = (i + 2) % 3;
    vector[i] = (s.m[i] + m[i]) * twist.imaginary + (m[j] * s.m[l] - m[l] * s.m[j]) * twist.real;
  }
  order.restore(vector, turn);
  const T w = (1 + (s.m[0] * m[0] + s.m[1] * m[1] + s.m[2] * m[2])) * twist.real;
  step.turn = {w, turn[0], turn[1], turn[2]};
  return step;
}

template <class T>
RIGOR_INLINE T load_lanes(const double* from) {
  T x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
template <class T>
RIGOR_INLINE void store_where(Mask<T> where, T value, double* into) {
  value = select(where, value, load_lanes<T>(into));
  __builtin_memcpy(into, &value, sizeof value);
}

/// Of the bodies from `at` on. Which of them are beyond.
template <class T>
RIGOR_INLINE Mask<T> step_at(const FreeBodies& bodies, std::size_t at) {
  T moment[3];
  T spin[3];
  for (int i = 0; i < 3; ++i) {
    moment[i] = load_lanes<T>(bodies.moments[i] + at);
    spin[i] = load_lanes<T>(bodies.spin[i] + at);
  }
  const T time = bodies.times == nullptr ? all<T>(bodies.time) : load_lanes<T>(bodies.times + at);
  const FreeStep<T> step = free_step<T>(moment, spin, time);
  double* const* const q = bodies.attitude;
  const Turn<T> before{load_lanes<T>(q[0] + at), load_lanes<T>(q[1] + at), load_lanes<T>(q[2] + at),
                       load_lanes<T>(q[3] + at)};
  const Turn<T> after = unit(before * step.turn);
  const Mask<T> within = negation(step.beyond);
  for (int i = 0; i < 3; ++i) store_where<T>(within, step.spin[i], bodies.spin[i] + at);
  store_where<T>(within, after.w, q[0] + at);
  store_where<T>(within, after.x, q[1] + at);
  store_where<T>(within, after.y, q[2] + at);
  store_where<T>(within, after.z, q[3] + at);
  return step.beyond;
}

/// All that are within; `beyond` gets the places of the others, and their number is returned.
RIGOR_INLINE std::size_t step_free_bodies(const FreeBodies& bodies, std::size_t* beyond) {
  std::size_t count = 0;
  std::size_t at = 0;
  for (; at + lanes <= bodies.count; at += lanes) {
    const LaneMask left = step_at<Lanes>(bodies, at);
    if (!any(left)) continue;
    for (int lane = 0; lane < lanes; ++lane)
      if (left[lane] != 0) beyond[count++] = at + static_cast<std::size_t>(lane);
  }
  for (; at < bodies.count; ++at)
    if (step_at<double>(bodies, at)) beyond[count++] = at;
  return count;
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
