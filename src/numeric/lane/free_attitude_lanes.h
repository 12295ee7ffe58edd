// SPDX-License-Identifier: GPL-3.0-or-later
// The attitude of torque_free_attitude.h. L rests in space: the attitude is the shortest turn that takes L's
// direction m in the body to the third axis, then a turn by χ about it. With axis 3 of the standard frame
// (m₃ > 0) nothing here is singular.
//
//   χ = ψ − arg(m₁ + i m₂),   dψ/dt = L (J₁ω₁² + J₂ω₂²)/(J₁²ω₁² + J₂²ω₂²) > 0,
//   ψ = A t + arg θ₄(v + iη | q) = A' t + arg θ₂(η' − iv' | q'),   sc(2Kη/π, k') = √(J₃P₁/J₁P₃),
//
// where A = ⟨dψ/dt⟩ is a complete integral of the third kind, whose terms are all positive, in two parts;
// A' = A − 2η' (dv'/dt)/L. Where η is nearer to its end −½ ln q the zero of θ₄ there is taken out: θ₁.
// Sources: C. G. J. Jacobi, J. reine angew. Math. 39 (1850) 293; R. van Zon, J. Schofield, J. Comput. Phys.
// 225 (2007) 145; R. Bulirsch, Numer. Math. 13 (1969) 305 (`cel`).
#pragma once

#include "numeric/lane/free_bodies.h"
#include "numeric/lane/free_spin_lanes.h"
#include "numeric/lane/torque_free_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

template <class T>
struct ComplexNumber {
  T real{};
  T imaginary{};
};
template <class T>
RIGOR_INLINE ComplexNumber<T> operator*(ComplexNumber<T> a, ComplexNumber<T> b) {
  return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
}

/// (w, x, y, z).
template <class T>
struct Turn {
  T w{};
  T x{};
  T y{};
  T z{};
};
/// `q` first.
template <class T>
RIGOR_INLINE Turn<T> operator*(Turn<T> p, Turn<T> q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}
template <class T>
RIGOR_INLINE Turn<T> unit(Turn<T> q) {
  const T inverse = 1 / root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * inverse, q.x * inverse, q.y * inverse, q.z * inverse};
}

/// The polynomial of `theta_at` at a complex G.
template <class T>
RIGOR_INLINE ComplexNumber<T> complex_theta_at(const double* t, ComplexNumber<T> g) {
  const ComplexNumber<T> square = g * g;
  const ComplexNumber<T> odd = g * ComplexNumber<T>{t[1] + t[3] * square.real, t[3] * square.imaginary};
  return {t[0] + t[2] * square.real + odd.real, t[2] * square.imaginary + odd.imaginary};
}
/// θ₃ with one term more, 2 q¹⁶ cos 8v = q¹² (G⁴ − 4 q² G² + 2 q⁴): G is larger off the real line.
template <class T>
RIGOR_INLINE ComplexNumber<T> complex_theta3_at(const FreeAttitude& at, ComplexNumber<T> g) {
  const ComplexNumber<T> square = g * g;
  const ComplexNumber<T> rest = square * ComplexNumber<T>{square.real - at.last[1], square.imaginary};
  const ComplexNumber<T> first = complex_theta_at<T>(at.spin.theta3, g);
  return {first.real + at.last[0] * rest.real, first.imaginary + at.last[0] * rest.imaginary};
}

/// e^{iψ} but for its size and a constant turn.
template <class T>
RIGOR_INLINE ComplexNumber<T> circular_azimuth(const FreeAttitude& at, SineCosine<T> v) {
  const T q2 = all<T>(2 * at.spin.nome);
  const T cosine = (v.cosine - v.sine) * (v.cosine + v.sine) * q2 * at.cosine[1];
  const T sine = v.sine * v.cosine * 2. * q2 * at.sine[1];
  if (!at.about_zero) return complex_theta3_at<T>(at, {-cosine, sine});
  const ComplexNumber<T> zero{v.sine * at.cosine[0], -v.cosine * at.sine[0]};
  const ComplexNumber<T> back{v.cosine, -v.sine};
  return back * zero * complex_theta_at<T>(at.spin.theta2, {-cosine, -sine});
}
template <class T>
RIGOR_INLINE ComplexNumber<T> hyperbolic_azimuth(const FreeAttitude& at, const HyperbolicPhase<T>& phase) {
  const T grown = at.spin.nome * phase.inverse * phase.inverse;
  const T shrunk = at.spin.nome * phase.factor * phase.factor;
  const T side = select(phase.at_end, -phase.sign, phase.sign);
  const ComplexNumber<T> g{(grown + shrunk) * at.cosine[1], (grown - shrunk) * side * at.sine[1]};
  const ComplexNumber<T> zero{phase.cosine * at.cosine[0], phase.sine * side * at.sine[0]};
  const ComplexNumber<T> theta2 = zero * complex_theta_at<T>(at.spin.theta2, g);
  const ComplexNumber<T> theta3 = complex_theta3_at<T>(at, g);
  return {select(phase.at_end, theta3.real, theta2.real),
          select(phase.at_end, theta3.imaginary, theta2.imaginary)};
}

/// From the standard frame in the body to axes that rest in space, the third along L.
template <class T>
RIGOR_INLINE Turn<T> turn_about_momentum(const FreeAttitude& at, T t) {
  const FreeSpin& spin = at.spin;
  constexpr double none[2] = {0, 0};
  DoubleDouble<T> turns = phase_at(none, at.turn_rate, t);
  Components<T> w;
  ComplexNumber<T> azimuth;
  if (spin.kind == FreeSpinKind::circular) {
    const SineCosine<T> v = circular_phase(spin, t);
    w = circular_spin(spin, v);
    azimuth = circular_azimuth(at, v);
  } else {
    const HyperbolicPhase<T> phase = hyperbolic_phase(spin, t);
    w = hyperbolic_spin(spin, phase);
    azimuth = hyperbolic_azimuth(at, phase);
    const T halves = phase.half_periods * 2. + select(phase.at_end, phase.sign, T{});
    const DoubleDouble<T> whole = exact_product(halves, all<T>(at.turn));
    turns = turns + whole;
  }
  const SineCosine<T> mean = sine_cosine_of_half_turns(turns);
  const T x = w.x * (at.moment[0] * spin.sign[0]);
  const T y = w.y * (at.moment[1] * spin.sign[1]);
  const T z = w.z * (at.moment[2] * spin.sign[2]);
  const T larger = greater(absolute(x), absolute(y));
  const ComplexNumber<T> meridian{x / larger, -y / larger};
  const ComplexNumber<T> e = ComplexNumber<T>{mean.cosine, mean.sine} * azimuth * meridian;
  const T size = root(e.real * e.real + e.imaginary * e.imaginary);
  const auto ahead = e.real >= 0;
  const T a = select(ahead, size + e.real, absolute(e.imaginary));  // cos χ/2, sin χ/2
  const T b = select(ahead, e.imaginary, with_sign(size - e.real, e.imaginary));
  const T length = root(x * x + y * y + z * z);
  const T up = length + z;
  return unit(Turn<T>{a * up, a * y + b * x, b * y - a * x, b * up});
}

/// The attitude in the body's own axes, w ≥ 0.
template <class T>
RIGOR_INLINE void attitude_at(const FreeAttitude& at, T time, T* into) {
  const FreeSpin& spin = at.spin;
  const T t = scaled_time(spin, time);
  if (spin.kind == FreeSpinKind::steady) {
    constexpr double none[2] = {0, 0};
    const SineCosine<T> half = sine_cosine_of_half_turns(phase_at(none, at.turn_rate, t));
    const T sign = with_sign(all<T>(1), half.cosine);
    into[0] = half.cosine * sign;
    for (int i = 0; i < 3; ++i) into[1 + i] = half.sine * sign * at.moment[i];
    return;
  }
  const Turn<T> p{all<T>(at.start[0]), all<T>(-at.start[1]), all<T>(-at.start[2]), all<T>(-at.start[3])};
  const Turn<T> q = turn_about_momentum<T>(at, t);
  const Turn<T> r = unit(p * q);
  const T sign = with_sign(all<T>(1), r.w);
  into[0] = r.w * sign;
  into[1 + spin.axis[0]] = r.x * sign * spin.sign[0];
  into[1 + spin.axis[1]] = r.y * sign * spin.sign[1];
  into[1 + spin.axis[2]] = r.z * sign * spin.sign[2];
}

/// The mean of (d₁ cn² + d₂ sn²)/(J₁ d₁ cn² + J₂ d₂ sn²) over a period, k' = b/a > 0. Relative error 1e-29.
RIGOR_INLINE Double2 mean_rate(const StandardFrame& frame, const Moduli& moduli) {
  const Double2 whole = frame.gap[0] * frame.moment[0];
  Double2 kc = quotient(moduli.b, moduli.a);
  Double2 p = square_root(quotient(frame.gap[1] * frame.moment[1], whole));
  Double2 a = quotient({1, 0}, {frame.moment[0], 0});
  Double2 b = quotient(frame.gap[1], whole * p);
  Double2 e = kc;
  Double2 m{1, 0};
  double power = 1;
  for (int level = 0; level < 20; ++level) {
    const Double2 f = a;
    a = like_sum(a, quotient(b, p));
    Double2 g = quotient(e, p);
    b = like_sum(b, f * g) * 2.;
    p = like_sum(p, g);
    g = m;
    m = like_sum(m, kc);
    power *= 2;
    if (absolute((g.high - kc.high) + (g.low - kc.low)) <= g.high * 0x1p-50) break;
    kc = square_root(e) * 2.;
    e = kc * m;
  }
  return quotient(like_sum(b, a * m), like_sum(m, p) * power);
}

/// η of circular_azimuth or η' of hyperbolic_azimuth.
RIGOR_INLINE void set_eta(const StandardFrame& frame, const Moduli& m, Double2 third, FreeAttitude& out) {
  const auto& [j1, j2, j3] = frame.moment;
  const double ratio = frame.scale1 / frame.scale3;
  const Double2 s2 = frame.p1 * j3 / (frame.p3 * j1);  // over ratio²
  const Double2 gap3 = frame.gap[2] * j3;
  const Double2 one{1, 0};
  Double2 sigma = root(s2) * ratio;
  // The other end's: √(J₁d₁/J₃d₃).
  out.about_zero = gap3.high > 0 && root(frame.gap[0].high * j1 / gap3.high) < sigma.high;
  if (out.about_zero) sigma = root(frame.gap[0] * j1 / gap3);
  const Double2 c = third * sigma;
  const Double2 delta = root(m.a * m.a + c * c);
  if (out.spin.kind == FreeSpinKind::circular) {
    const double sine = (sigma * descend(m.a, m.b, delta).sine).high;
    out.cosine[0] = root(1 + sine * sine);
    out.sine[0] = sine;
    out.cosine[1] = 1 + 2 * sine * sine;
    out.sine[1] = 2 * sine * out.cosine[0];
    return;
  }
  const Double2 secant = root(sigma * sigma + 1.);
  const Double2 tangent = sigma * descend(m.a, third, delta / secant).tangent;
  const Double2 x = out.about_zero ? tangent : one;
  const Double2 y = out.about_zero ? one : tangent;
  const double size = root(x.high * x.high + y.high * y.high);
  out.turn = half_turns_of(x, y).high;
  out.cosine[0] = x.high / size;
  out.sine[0] = y.high / size;
  out.cosine[1] = (out.cosine[0] - out.sine[0]) * (out.cosine[0] + out.sine[0]);
  out.sine[1] = 2 * out.cosine[0] * out.sine[0];
}

/// Of inputs as for `set_free_spin`.
RIGOR_INLINE void set_free_attitude(const double* moments, const double* spin, FreeAttitude& out) {
  StandardFrame frame;
  set_free_spin(moments, spin, out.spin, frame);
  if (out.spin.kind == FreeSpinKind::steady) {
    if (out.spin.scale == 0) return;
    Double2 square{};
    for (int i = 0; i < 3; ++i)
      square = square + exact_product(spin[i] / out.spin.scale, spin[i] / out.spin.scale);
    const Double2 size = root(square);
    for (int i = 0; i < 3; ++i) out.moment[i] = spin[i] / out.spin.scale / size.high;
    const Double2 rate = size * inverse_pi * 0.5;
    out.turn_rate[0] = rate.high;
    out.turn_rate[1] = rate.low;
    return;
  }
  const Moduli m = moduli_of(frame);
  Double2 square{};
  for (int i = 0; i < 3; ++i) {
    const Double2 part = exact_product(frame.moment[i], frame.spin[i]);
    square = square + part * part;
    out.moment[i] = frame.moment[i];
  }
  set_eta(frame, m, third_modulus(frame, m), out);
  Double2 rate = square_root(square) * inverse_pi *
                 (m.b.high == 0 ? Double2{1, 0} / Double2{frame.moment[1], 0} : mean_rate(frame, m));
  if (out.spin.kind == FreeSpinKind::hyperbolic && m.b.high != 0) {
    const Double2 phase_rate{out.spin.rate[0], out.spin.rate[1]};
    const Double2 half_period{out.spin.half_period[0], out.spin.half_period[1]};
    rate = rate - phase_rate / half_period * (2 * out.turn);
  }
  const double q2 = out.spin.nome * out.spin.nome;
  out.last[0] = q2 * q2 * q2 * q2 * q2 * q2;
  out.last[1] = 4 * q2;
  out.turn_rate[0] = rate.high;
  out.turn_rate[1] = rate.low;
  const Turn<double> start = turn_about_momentum<double>(out, 0);
  out.start[0] = start.w;
  out.start[1] = start.x;
  out.start[2] = start.y;
  out.start[3] = start.z;
}

/// As `attitude_at` for each of `count` times, to the last bit; four doubles a time.
RIGOR_INLINE void attitudes_at(const FreeAttitude& at, const double* times, std::size_t count, double* into) {
  std::size_t done = 0;
  for (; done + lanes <= count; done += lanes) {
    Lanes turns[4];
    attitude_at<Lanes>(at, load(times + done), turns);
    for (int lane = 0; lane < lanes; ++lane) {
      for (int i = 0; i < 4; ++i)
        into[4 * (done + static_cast<std::size_t>(lane)) + static_cast<std::size_t>(i)] = turns[i][lane];
    }
  }
  for (; done < count; ++done) attitude_at<double>(at, times[done], into + 4 * done);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
