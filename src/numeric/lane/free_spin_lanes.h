// SPDX-License-Identifier: GPL-3.0-or-later
// The spin of torque_free.h at many times, from quotients of theta functions: DLMF 22.2, and 22.4 (Jacobi's
// imaginary transformation) for the hyperbolic kind. Every component has a relative error of its own, of
// about 8 u: its zeros are factors, and phases have two parts, so that a zero is where it is to 1e-21.
#pragma once

#include "numeric/lane/elliptic_lanes.h"
#include "numeric/lane/free_bodies.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

template <class T>
struct Components {
  T x{};
  T y{};
  T z{};
};

/// The time in units of 1/scale; not a number where it is not finite or too long for its phase to have one.
template <class T>
RIGOR_INLINE T scaled_time(const FreeSpin& spin, T t) {
  const T scaled = t * spin.scale;
  return select(absolute(scaled) < 0x1p900, scaled, all<T>(__builtin_nan("")));
}

/// The phase at t, in two parts.
template <class T>
RIGOR_INLINE DoubleDouble<T> phase_at(const double* start, const double* rate, T t) {
  DoubleDouble<T> p = exact_product(all<T>(rate[0]), t);
  p.low = p.low + rate[1] * t;
  const DoubleDouble<T> sum = exact_sum(p.high, all<T>(start[0]));
  return normalised(sum.high, sum.low + (p.low + start[1]));
}

/// ω₁ ∝ cos v θ₂/θ₄, ω₂ ∝ sin v θ₁/θ₄, ω₃ ∝ θ₃/θ₄ (the zeros taken out of θ₂ and θ₁).
template <class T>
RIGOR_INLINE Components<T> circular_spin(const FreeSpin& spin, SineCosine<T> v) {
  const T g = (v.cosine - v.sine) * (v.cosine + v.sine) * (2 * spin.nome);
  const EvenOdd<T> theta3 = theta_at(spin.theta3, g);
  const EvenOdd<T> theta2 = theta_at(spin.theta2, g);
  const T inverse = 1 / theta3.minus;
  return {v.cosine * theta2.plus * inverse * spin.amplitude[0],
          v.sine * theta2.minus * inverse * spin.amplitude[1], theta3.plus * inverse * spin.amplitude[2]};
}
template <class T>
RIGOR_INLINE SineCosine<T> circular_phase(const FreeSpin& spin, T t) {
  return sine_cosine_of_half_turns(phase_at(spin.start, spin.rate, t));
}

/// v' = n L ± w or, at the end of a half period, n L ± (L/2 − w).
template <class T>
struct HyperbolicPhase {
  T half_periods{};  // n
  T sign{};
  Mask<T> at_end{};
  T factor{};   // e⁻ʷ
  T inverse{};  // eʷ
  T sine{};     // 2 e⁻ʷ sinh w
  T cosine{};   // 2 e⁻ʷ cosh w
};
template <class T>
RIGOR_INLINE HyperbolicPhase<T> hyperbolic_phase(const FreeSpin& spin, T t) {
  HyperbolicPhase<T> phase;
  const DoubleDouble<T> v = phase_at(spin.start, spin.rate, t);
  const T halves = v.high * spin.inverse_half_period;
  const T n = select(absolute(halves) < most_half_turns, nearest_integer(halves), all<T>(__builtin_nan("")));
  const DoubleDouble<T> whole = exact_product(n, all<T>(spin.half_period[0]));
  const DoubleDouble<T> left = exact_difference(v.high, whole.high);
  const DoubleDouble<T> rest =
      normalised(left.high, left.low + (v.low - (whole.low + n * spin.half_period[1])));
  phase.half_periods = n;
  phase.sign = with_sign(all<T>(1), rest.high);
  const DoubleDouble<T> w{rest.high * phase.sign, rest.low * phase.sign};
  const T quarter = all<T>(0.25 * spin.half_period[0]);
  phase.at_end = (w.high > quarter) & (quarter > 0);
  const DoubleDouble<T> end = exact_difference(all<T>(0.5 * spin.half_period[0]), w.high);
  const T end_low = end.low + (0.5 * spin.half_period[1] - w.low);
  const DoubleDouble<T> nearer =
      normalised(select(phase.at_end, end.high, w.high), select(phase.at_end, end_low, w.low));
  const T side = with_sign(all<T>(1), nearer.high);  // rounding may lead across the end
  const Decay<T> e = decay(DoubleDouble<T>{nearer.high * side, nearer.low * side});
  phase.factor = e.factor;
  phase.inverse = 1 / e.factor;
  phase.sine = -e.change * (2 + e.change) * side;
  phase.cosine = 1 + e.factor * e.factor;
  return phase;
}

/// Near v' = 0 as sech, tanh, sech; near ±L/2 the same seen from the other half of the path.
template <class T>
RIGOR_INLINE Components<T> hyperbolic_spin(const FreeSpin& spin, const HyperbolicPhase<T>& phase) {
  const T g =
      spin.nome * phase.factor * phase.factor + (spin.nome * phase.inverse) * phase.inverse;  // 2 q' cosh 2w
  const EvenOdd<T> theta3 = theta_at(spin.theta3, g);
  const EvenOdd<T> theta2 = theta_at(spin.theta2, g);
  const T even = phase.cosine * theta2.plus;
  const T odd = phase.sine * theta2.minus;
  const T top = select(phase.at_end, theta3.plus, even);
  const T small = select(phase.at_end, all<T>(2 * spin.root_nome) * phase.inverse, 2 * phase.factor) / top;
  const T half = phase.half_periods * 0.5;
  const T turn = select(half == nearest_integer(half), all<T>(1), all<T>(-1));
  return {select(phase.at_end, odd, theta3.minus) * small * turn * spin.amplitude[0],
          select(phase.at_end, theta3.minus, odd) / top * (phase.sign * turn) * spin.amplitude[1],
          select(phase.at_end, even, theta3.plus) * small * spin.amplitude[2]};
}

/// Along the axes of the standard frame, with their signs: as the body has them.
template <class T>
RIGOR_INLINE Components<T> standard_spin(const FreeSpin& spin, T time) {
  const T t = scaled_time(spin, time);
  return spin.kind == FreeSpinKind::circular ? circular_spin(spin, circular_phase(spin, t))
                                             : hyperbolic_spin(spin, hyperbolic_phase(spin, t));
}

/// Sets one spin, three doubles.
RIGOR_INLINE void free_spin_at(const FreeSpin& spin, double t, double* into) {
  if (spin.kind == FreeSpinKind::steady) {
    for (int i = 0; i < 3; ++i) into[i] = spin.spin[i] + 0 * t;
    return;
  }
  const Components<double> w = standard_spin<double>(spin, t);
  into[spin.axis[0]] = w.x;
  into[spin.axis[1]] = w.y;
  into[spin.axis[2]] = w.z;
}

/// As `free_spin_at` for each of `count` times, to the last bit; three doubles a time.
RIGOR_INLINE void free_spins_at(const FreeSpin& spin, const double* times, std::size_t count, double* into) {
  std::size_t done = 0;
  for (; spin.kind != FreeSpinKind::steady && done + lanes <= count; done += lanes) {
    const Components<Lanes> w = standard_spin<Lanes>(spin, load(times + done));
    double* at = into + 3 * done;
    for (int lane = 0; lane < lanes; ++lane, at += 3) {
      at[spin.axis[0]] = w.x[lane];
      at[spin.axis[1]] = w.y[lane];
      at[spin.axis[2]] = w.z[lane];
    }
  }
  for (; done < count; ++done) free_spin_at(spin, times[done], into + 3 * done);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
