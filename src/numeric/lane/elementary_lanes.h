// SPDX-License-Identifier: GPL-3.0-or-later
// Sine, cosine and exponential in lanes, the same bits on every machine, of arguments in two parts: what is
// left of a large phase after its periods have been taken off. T is `double` or `Lanes`.
#pragma once

#include "numeric/lane/double_double.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

inline constexpr double pi_high = 3.141592653589793;
inline constexpr double pi_low = 1.2246467991473532e-16;
inline constexpr DoubleDouble<double> inverse_pi{0.3183098861837907, -1.9678676675182486e-17};

/// 3/2 · 2^52: a sum with it is an integer, in the low bits.
inline constexpr double integer_shift = 6755399441055744;

/// The phases of periodic functions that have a value, in half turns: 2^47 turns. Beyond they are not a
/// number.
inline constexpr double most_half_turns = 0x1p48;

/// The nearest integer of |x| < 2^51; any of two. Beyond, x.
template <class T>
RIGOR_INLINE T nearest_integer(T x) {
  const T r = (x + integer_shift) - integer_shift;
  return select(absolute(x) < integer_shift / 3, r, x);
}

RIGOR_INLINE double power_of_two(double n) {
  const double shifted = n + (integer_shift + 1023);
  std::int64_t bits;
  __builtin_memcpy(&bits, &shifted, sizeof bits);
  bits = (std::int64_t)((std::uint64_t)bits << 52);
  double power;
  __builtin_memcpy(&power, &bits, sizeof power);
  return power;
}
/// 2ⁿ for integers −1022 ≤ n ≤ 1023.
RIGOR_INLINE Lanes power_of_two(Lanes n) { return (Lanes)((LaneMask)(n + (integer_shift + 1023)) << 52); }

template <class T>
struct SineCosine {
  T sine{};
  T cosine{};
};

/// sin x, cos x for |x.high| ≤ 0.8, Taylor's series to x¹⁷ (remainder below 2^-63). Relative error 1.1 u
/// each.
template <class T>
RIGOR_INLINE SineCosine<T> small_sine_cosine(DoubleDouble<T> x) {
  const T z = x.high * x.high;
  const T y = z * z;  // even and odd powers of z apart: half the waiting
  T p = 1 / 6227020800. + y * (1 / 355687428096000.);
  p = y * p + 1 / 362880.;
  p = y * p + 1 / 120.;
  T odd = 1 / 1307674368000. + y * (1 / 121645100408832000.);
  odd = y * odd + 1 / 39916800.;
  odd = y * odd + 1 / 5040.;
  p = z * (p - z * odd) - 1 / 6.;
  T q = 1 / 479001600. + y * (1 / 20922789888000.);
  q = y * q + 1 / 40320.;
  q = y * q + 1 / 24.;
  odd = 1 / 87178291200. + y * (1 / 6402373705728000.);
  odd = y * odd + 1 / 3628800.;
  odd = y * odd + 1 / 720.;
  q = q - z * odd;
  const T half = z * 0.5;
  const T w = 1 - half;
  return {x.high + (z * x.high * p + x.low * w), w + (((1 - w) - half) + (z * z * q - x.high * x.low))};
}

/// sin πy, cos πy for |y| < 2^48, else not a number. Relative error 2 u each, also next to their zeros, as
/// far as y's two parts go.
template <class T>
RIGOR_INLINE SineCosine<T> sine_cosine_of_half_turns(DoubleDouble<T> y) {
  const T quarters =
      select(absolute(y.high) < most_half_turns, nearest_integer(y.high * 2), all<T>(__builtin_nan("")));
  const DoubleDouble<T> rest = normalised(y.high - quarters * 0.5, y.low);
  const DoubleDouble<T> x = rest * DoubleDouble<T>{all<T>(pi_high), all<T>(pi_low)};
  const SineCosine<T> small = small_sine_cosine(x);
  const T m = quarters - nearest_integer(quarters * 0.25) * 4;  // −2 … 2
  const auto odd = absolute(m) == 1;
  const T s = select(odd, small.cosine, small.sine);
  const T c = select(odd, small.sine, small.cosine);
  return {select((m < 0) | (m > 1.5), -s, s), select((absolute(m) > 1.5) | (m == 1), -c, c)};
}

/// e⁻ʷ and e⁻ʷ − 1.
template <class T>
struct Decay {
  T factor{};
  T change{};
};

/// For w ≥ 0, taken as 700 from there on. Taylor's series to r¹⁴, |r| ≤ ½ ln 2 (remainder below 2^-57).
/// Relative error 2 u each.
template <class T>
RIGOR_INLINE Decay<T> decay(DoubleDouble<T> w) {
  const auto far = w.high > 700;
  const T high = select(far, all<T>(-700), -w.high);
  const T low = select(far, T{}, -w.low);
  const T n = nearest_integer(high * 1.4426950408889634);
  const T nearer = high - n * 0.6931471803691238;  // exact: 32 bits of ln 2, and 11 of n
  const DoubleDouble<T> r = exact_difference(nearer, n * 1.9082149292705877e-10);
  const T rest = r.low + low;
  const T z = r.high;
  T p = 1 / 6227020800. + z * (1 / 87178291200.);
  p = z * p + 1 / 479001600.;
  p = z * p + 1 / 39916800.;
  p = z * p + 1 / 3628800.;
  p = z * p + 1 / 362880.;
  p = z * p + 1 / 40320.;
  p = z * p + 1 / 5040.;
  p = z * p + 1 / 720.;
  p = z * p + 1 / 120.;
  p = z * p + 1 / 24.;
  p = z * p + 1 / 6.;
  p = z * p + 0.5;
  const T inner = z * z * p;
  const T change = z + (inner + rest * (1 + (z + inner)));  // eʳ − 1
  const T scale = power_of_two(n);
  return {scale + scale * change, (scale - 1) + scale * change};
}

/// cos and sin of j π/64.
inline constexpr double sixty_fourths[17][4] = {
    {1.0, 0.0, 0.0, 0.0},
    {0.9987954562051724, -1.2291693337075465e-17, 0.049067674327418015, -6.79610372051828e-19},
    {0.9951847266721969, -4.248691367830441e-17, 0.0980171403295606, -1.634582362244256e-18},
    {0.989176509964781, -4.098730993704711e-17, 0.14673047445536175, 3.726947147046568e-18},
    {0.9807852804032304, 1.8546939997825006e-17, 0.19509032201612828, -7.991079068461731e-18},
    {0.970031253194544, 1.8365300348428844e-17, 0.2429801799032639, -8.751431529719663e-18},
    {0.9569403357322088, 4.05538698618757e-17, 0.2902846772544624, -1.892797870777425e-17},
    {0.9415440651830208, -2.789637954769834e-17, 0.33688985339222005, -4.200094003347509e-19},
    {0.9238795325112867, 1.7645047084336677e-17, 0.3826834323650898, -1.0050772696461588e-17},
    {0.9039892931234433, -6.609754468748431e-18, 0.4275550934302821, 9.411189816295473e-18},
    {0.881921264348355, -1.9843248405890562e-17, 0.47139673682599764, 6.516678136069013e-18},
    {0.8577286100002721, -4.818344793633662e-17, 0.5141027441932218, -4.5712707523615624e-17},
    {0.8314696123025452, 1.4073856984728024e-18, 0.5555702330196022, 4.709410940561677e-17},
    {0.8032075314806449, -3.306060980481491e-17, 0.5956993044924334, -1.3438641936579467e-17},
    {0.773010453362737, -3.256590703364977e-17, 0.6343932841636455, 1.0420901929280035e-17},
    {0.7409511253549591, -1.4708616952297345e-17, 0.6715589548470184, -4.048903774929669e-17},
    {0.7071067811865476, -4.833646656726457e-17, 0.7071067811865476, -4.833646656726457e-17},
};

/// The angle of (x, y) ≠ 0 over π, −1 to 1. Error 1e-21: of atan's series the first term has two parts.
/// Method: the nearest multiple of π/64 is taken off by a rotation.
RIGOR_INLINE DoubleDouble<double> half_turns_of(DoubleDouble<double> x, DoubleDouble<double> y) {
  DoubleDouble<double> c = x.high < 0 ? -x : x;
  DoubleDouble<double> s = y.high < 0 ? -y : y;
  const bool steep = s.high > c.high;
  if (steep) {
    const DoubleDouble<double> swap = c;
    c = s;
    s = swap;
  }
  const double slope = s.high / c.high;
  // 64/π atan, within 0.1; of what is not a number the table's first, and the result is none either.
  const double j = slope <= 1 ? nearest_integer(slope * (16 + 5.56 * (1 - slope))) : 0;
  const double* at = sixty_fourths[(int)j];
  // z = tan of what is left = (s cⱼ − c sⱼ) / (c cⱼ + s sⱼ)
  const DoubleDouble<double> near = exact_product(s.high, at[0]);
  const DoubleDouble<double> far = exact_product(c.high, at[2]);
  const DoubleDouble<double> y_high = exact_difference(near.high, far.high);
  const double y_low = y_high.low + ((near.low - far.low) +
                                     ((s.high * at[1] + s.low * at[0]) - (c.high * at[3] + c.low * at[2])));
  const DoubleDouble<double> along = exact_product(c.high, at[0]);
  const DoubleDouble<double> across = exact_product(s.high, at[2]);
  const DoubleDouble<double> x_high = exact_sum(along.high, across.high);
  const double x_low = x_high.low + ((along.low + across.low) +
                                     ((c.high * at[1] + c.low * at[0]) + (s.high * at[3] + s.low * at[2])));
  const double q = y_high.high / x_high.high;
  const DoubleDouble<double> p_high = exact_product(q, x_high.high);
  const DoubleDouble<double> z =
      normalised(q, (((y_high.high - p_high.high) - p_high.low) + (y_low - q * x_low)) / x_high.high);
  const double w = z.high * z.high;
  double p = 1 / 13. - w * (1 / 15.);
  p = 1 / 11. - w * p;
  p = 1 / 9. - w * p;
  p = 1 / 7. - w * p;
  p = 1 / 5. - w * p;
  p = 1 / 3. - w * p;
  DoubleDouble<double> turn = (z + -z.high * w * p) * inverse_pi + j / 64;
  if (steep) turn = -turn + 0.5;
  if (x.high < 0) turn = -turn + 1.;
  return y.high < 0 ? -turn : turn;
}

/// ln x for 1 ≤ x < 2^990, and that of 2^990 beyond. Error 1e-21: one step of Newton's on 5 digits, in two
/// parts.
/// Method: e⁻ʸ from Taylor's series at a 64th of what is left of y, squared six times.
RIGOR_INLINE DoubleDouble<double> logarithm(DoubleDouble<double> x) {
  const DoubleDouble<double> ln_2{0.6931471805599453, 2.3190468138462996e-17};
  if (x.high >= 0x1p990) x = {0x1p990, 0};
  const double scale = power_below(x.high);
  std::int64_t bits;
  __builtin_memcpy(&bits, &scale, sizeof bits);
  double y = (double)((bits >> 52) - 1023) * ln_2.high;
  const double g = (x.high / scale - 1) / (x.high / scale + 1);
  y += 2 * g * (1 + g * g * (1 / 3. + g * g * (1 / 5. + g * g * (1 / 7.))));
  const double n = nearest_integer(y / ln_2.high);
  const DoubleDouble<double> r = (ln_2 * n + -y) * (1 / 64.);
  DoubleDouble<double> e{1, 0};
  for (double k = 10; k > 1; k -= 1) e = e * r / DoubleDouble<double>{k, 0} + 1.;  // (eʳ − 1)/r
  e = e * r;
  for (int k = 0; k < 6; ++k) e = e * (e + 2.);
  const double power = power_of_two(-n);
  const DoubleDouble<double> z = (x * power) * (e + 1.) + -1.;
  return z + y + -z.high * z.high * (0.5 - z.high * (1 / 3. - z.high * 0.25));
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
