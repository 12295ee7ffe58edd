// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues of one symmetric 3×3 tensor that lie apart, and their gaps, rounded once: the bits that any
// more careful computation has, too. Where they do not lie apart, or a result is too near the middle of two
// doubles, it says so.
//
// * b = a − s 1, s the mean of the a_ii, exactly in two parts. f(x) = det(x 1 − b) = x³ − c₂x² − Sx − c₀ with
//   S = ½ Σ b_ii² + Σ b_jk² and c₀ = det b in double-double, and c₂ = tr b, which is as small as the rounding
//   of s.
// * The roots in plain doubles: x = ±βp with p = √(S/3) and β³ − 3β = c₀/p³, and −x/2 ± √(S − ¾x²).
// * One step for all three, f(x) in double-double: d = −f/f', and then d − 3x d²/f', which leaves out d³.
//
// A polynomial whose roots are real has one within 3|f/f'| of x, so that no root is found twice: where the
// slopes are at least 2^-9 S, the x are 2^-9 p apart. The error of x + d is then below 2^-74 p: that of f is
// some thousand roundings of v p³, v = 2^-106; of f', 2^-48 p², times d; of the cubic terms left out, 2^21
// d³/p². Cost: 350 operations, 2 divisions and 2 roots one after the other.
#pragma once

#include "numeric/lane/nearly_diagonal_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// In units of S, p, p and 1: how steep f is at least at its roots, how far these may be from where they were
/// looked for, how well they are known then, and how large the sizes may be beside p.
inline constexpr double least_slope = 0x1p-9;
inline constexpr double longest_step = 0x1p-34;
inline constexpr double distinct_rounding = 0x1p-72;
inline constexpr double greatest_shift = 16;

/// Ascending, in parts 0, 1, 2, and the gaps in parts 0 and 1; other parts repeat them.
struct DistinctMoments {
  DoubleDouble<Quad> moments;
  DoubleDouble<Quad> gaps;
  double error;  // at most, of each as high + low
  bool known;    // else nothing is known
};

/// The characteristic polynomial x³ − `trace` x² − `linear` x − `constant`.
struct CharacteristicPolynomial {
  double trace;
  DoubleDouble<double> linear;
  DoubleDouble<double> constant;
};

/// `diagonal`: 0, 1, 2, 0 and what its low parts are; `off`: 0, 1, 2, 1.
RIGOR_INLINE CharacteristicPolynomial characteristic_polynomial(DoubleDouble<Quad> diagonal, Quad off) {
  using One = DoubleDouble<double>;
  using Four = DoubleDouble<Quad>;
  const Quad none = all<Quad>(0);
  const auto& [high, low] = diagonal;
  CharacteristicPolynomial f;
  const One two = exact_sum(high[0], high[1]);
  f.trace = ((two.high + high[2]) + two.low) + ((low[0] + low[1]) + low[2]);
  // b₂₃², b₃₁², b₁₂² and b₂₂b₃₃; b₁₁², b₂₂², b₃₃² and b₂₃b₃₁.
  const Four minors = raw_product(Four{parts<0, 1, 2, 5>(off, high), parts<0, 1, 2, 5>(none, low)},
                                  Four{parts<0, 1, 2, 6>(off, high), parts<0, 1, 2, 6>(none, low)});
  const Four squares = raw_product(Four{parts<0, 1, 2, 4>(high, off), parts<0, 1, 2, 4>(low, none)},
                                   Four{parts<0, 1, 2, 5>(high, off), parts<0, 1, 2, 5>(low, none)});
  const Four sums = exact_sum(0.5 * squares.high, minors.high);
  const Quad sum_lows = sums.low + (minors.low + 0.5 * squares.low);
  const One first = exact_sum(sums.high[0], sums.high[1]);
  const One second = exact_sum(first.high, sums.high[2]);
  f.linear = {second.high, (second.low + first.low) + ((sum_lows[0] + sum_lows[1]) + sum_lows[2]) -
                               0.5 * (f.trace * f.trace)};
  // −b₁₁b₂₃², −b₂₂b₃₁², −b₃₃b₁₂² and b₁₁b₂₂b₃₃; 2b₂₃b₃₁b₁₂.
  const Quad sign = quad(-1, -1, -1, 1);
  const Four triples = raw_product(minors, Four{high * sign, low * sign});
  const One last = raw_product(One{squares.high[3], squares.low[3]}, 2 * off[2]);
  const One halves[2] = {exact_sum(triples.high[0], triples.high[1]),
                         exact_sum(triples.high[2], triples.high[3])};
  const One four = exact_sum(halves[0].high, halves[1].high);
  const One five = exact_sum(four.high, last.high);
  const double lows = ((triples.low[0] + triples.low[1]) + (triples.low[2] + triples.low[3])) + last.low;
  f.constant = {five.high, (five.low + (four.low + (halves[0].low + halves[1].low))) + lows};
  return f;
}

/// By rows; only the lower triangle is read.
RIGOR_INLINE DistinctMoments distinct_moments(const double* tensor) {
  using Four = DoubleDouble<Quad>;
  const double* const t = tensor;
  const Quad shift = all<Quad>((t[0] + t[4] + t[8]) * (1. / 3));
  const CharacteristicPolynomial f = characteristic_polynomial(
      exact_difference(quad(t[0], t[4], t[8], t[0]), shift), quad(t[7], t[6], t[3], t[6]));
  const double size = root(f.linear.high * (1. / 3));
  const double inverse = 1 / f.linear.high;
  const double r = (f.constant.high * inverse) * (inverse * size * 4.5);  // det/(2 p³)
  const double separate = with_sign(greatest_cubic_root(absolute(r)) * size, r);
  const double half_gap = root(f.linear.high - 0.75 * (separate * separate));
  const Quad x = quad(-0.5 * separate - half_gap, -0.5 * separate + half_gap, separate, separate);

  // f(x) = (x² − S) x − c₀ − c₂x²
  const Four square = exact_product(x, x);
  const Four less = exact_difference(square.high, all<Quad>(f.linear.high));
  const Four cubic = raw_product(Four{less.high, less.low + (square.low - f.linear.low)}, x);
  const Four rest = exact_difference(cubic.high, all<Quad>(f.constant.high));
  const Quad value = rest.high + (rest.low + (cubic.low - (f.constant.low + f.trace * square.high)));
  const Quad slope = (3 * square.high - f.linear.high) - (2 * f.trace) * x;
  const Quad rate = 1 / slope;
  const Quad step = -(value * rate);
  const Quad steps = step * (1 - (3 * x * rate) * step);

  const bool separate_first = separate < 0;
  const Quad at = select(separate_first, parts<2, 0, 1, 1>(x, x), x);
  const Quad beside = select(separate_first, parts<2, 0, 1, 1>(steps, steps), steps);
  const Four apart = exact_difference(parts<1, 2, 2, 2>(at, at), parts<0, 1, 1, 1>(at, at));
  const Four moments = exact_sum(shift, at);
  DistinctMoments d;
  d.gaps = normalised(apart.high,
                      apart.low + (parts<1, 2, 2, 2>(beside, beside) - parts<0, 1, 1, 1>(beside, beside)));
  d.moments = normalised(moments.high, moments.low + beside);
  d.error = distinct_rounding * size;
  d.known = in_all((absolute(slope) >= all<Quad>(least_slope * f.linear.high)) &
                   (absolute(step) <= all<Quad>(longest_step * size))) &
            (size > 0x1p-200) & (size < 0x1p200) & (absolute(shift[0]) <= greatest_shift * size);
  return d;
}

/// Whether all that is within `error` of these numbers rounds to their high parts.
RIGOR_INLINE QuadMask is_rounded(DoubleDouble<Quad> x, Quad error) {
  return (x.high + (x.low + error) == x.high) & (x.high + (x.low - error) == x.high);
}

/// Whether they are found so, rounded.
inline bool rounded_distinct_moments(const double* tensor, double* moments, double* gaps) {
  const DistinctMoments d = distinct_moments(tensor);
  const Quad error = all<Quad>(d.error);
  for (int k = 0; k < 3; ++k) moments[k] = d.moments.high[k];
  for (int k = 0; k < 2; ++k) gaps[k] = d.gaps.high[k];
  return d.known & in_all(is_rounded(d.moments, error) & is_rounded(d.gaps, error));
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
