// SPDX-License-Identifier: GPL-3.0-or-later
// Two eigenvalues of a symmetric 3×3 tensor that are so close that 106 bits do not tell their gap: a body of
// revolution in any attitude, whose tensor is rounded to doubles.
//
// With X the three axes in plain doubles, orthonormal to some u, and s the mean of the two eigenvalues:
// * r = (b − s 1) x is only as large as the gap and the errors of x. Its three leading products cancel, and
//   what they leave is summed exactly, so that r has 106 bits below its own size, not below that of b;
// * XᵀbX − s XᵀX, the Gram matrix XᵀX to first order beyond 1 and the third axis to second order, is a 2×2
//   problem with an error of `close_pair_rounding`.
// Whether the two are exactly equal is told exactly: b − s 1 is then a multiple of n nᵀ. Cost: 900
// operations.
#pragma once

#include "numeric/lane/nearly_diagonal_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// In units of b, which has entries up to 2: some 60 terms of u³, times sums over three of some 10 u.
inline constexpr double close_pair_rounding = 0x1p-143;

/// Unit vectors to some u, and orthogonal to some u; not ordered.
template <class T>
struct Frame {
  T pair[2][3];
  T separate[3];
};

/// The diagonal of b without any rounding: first, second and third parts.
template <class T>
struct ExactDiagonal {
  T first[3];
  T second[3];
  T third[3];
};

/// (b − s 1) x for a unit vector x that nearly solves it. Not normalised.
template <bool sharp, class T>
struct Residual {
  DoubleDouble<T> at[3];

  RIGOR_INLINE Residual(const ExactDiagonal<T>& diagonal, const SymmetricTensor<T>& b, T s, const T* x) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const DoubleDouble<T> entry = exact_difference(diagonal.first[i], s);
      DoubleDouble<T> tail = exact_sum(entry.low, diagonal.second[i]);
      if constexpr (sharp) {
        const DoubleDouble<T> more = exact_sum(tail.high, diagonal.third[i]);
        tail = {more.high, tail.low + more.low};
      }
      const DoubleDouble<T> products[3] = {exact_product(entry.high, x[i]),
                                           exact_product(b.off[k].high, x[j]),
                                           exact_product(b.off[j].high, x[k])};
      const DoubleDouble<T> first = exact_sum(products[0].high, products[1].high);
      const DoubleDouble<T> second = exact_sum(first.high, products[2].high);
      // From here on all is as small as the residual.
      CompensatedSum<T> sum = sum_of(exact_sum(second.high, first.low));
      sum.add(second.low);
      for (const DoubleDouble<T>& product : products) sum.add(product.low);
      sum.add(exact_product(tail.high, x[i]));
      sum.low = sum.low + tail.low * x[i];
      if constexpr (sharp) {
        sum.add(exact_product(b.off[k].low, x[j]));
        sum.add(exact_product(b.off[j].low, x[k]));
      }
      at[i] = sum.raw();
    }
  }

  /// Along a vector of doubles.
  [[nodiscard]] RIGOR_INLINE DoubleDouble<T> along(const T* x) const {
    CompensatedSum<T> sum = sum_of(raw_product(at[0], x[0]));
    for (int i = 1; i < 3; ++i) sum.add(raw_product(at[i], x[i]));
    return sum.raw();
  }
};

/// x·y − `expected`, which is small.
template <class T>
RIGOR_INLINE T excess_of_product(const T* x, const T* y, double expected) {
  CompensatedSum<T> sum = sum_of(exact_product(x[0], y[0]));
  if (expected != 0) sum.add(all<T>(-expected));
  for (int i = 1; i < 3; ++i) sum.add_product(x[i], y[i]);
  return sum.high + sum.low;
}

/// What solves the pair: eigenvalues mean + middle ± difference/2 of the first axis and the second one.
template <class T>
struct ClosePair {
  T middle;
  T difference;
  Frame<T> frame;
};

/// b has this diagonal. `mean`, of the pair, to 2^-90 or so; `apart`: the third eigenvalue less that.
template <bool sharp, class T>
RIGOR_INLINE ClosePair<T> close_pair(const ExactDiagonal<T>& diagonal, const SymmetricTensor<T>& b,
                                     const Frame<T>& x, DoubleDouble<T> mean, T apart) {
  const Residual<sharp, T> rest[2] = {{diagonal, b, mean.high, x.pair[0]},
                                      {diagonal, b, mean.high, x.pair[1]}};
  const T gram[3] = {excess_of_product(x.pair[0], x.pair[0], 1), excess_of_product(x.pair[1], x.pair[1], 1),
                     excess_of_product(x.pair[0], x.pair[1], 0)};
  const T towards_gram[2] = {excess_of_product(x.pair[0], x.separate, 0),
                             excess_of_product(x.pair[1], x.separate, 0)};
  const T separate_gram = excess_of_product(x.separate, x.separate, 1);

  // The third axis, to second order.
  T towards[2];
  T tilt[2];
  for (int p = 0; p < 2; ++p) {
    const DoubleDouble<T> along = rest[p].along(x.separate);
    towards[p] = (along.high + along.low) - mean.low * towards_gram[p];
    tilt[p] = towards[p] / apart;
  }
  const DoubleDouble<T> a[2] = {rest[0].along(x.pair[0]), rest[1].along(x.pair[1])};
  const DoubleDouble<T> off = rest[0].along(x.pair[1]);
  const auto reduced_entry = [&](int p) RIGOR_INLINE_LAMBDA {
    return (a[p].high - mean.low) + (a[p].low - (mean.low * gram[p] + towards[p] * tilt[p]));
  };
  const T entry[2] = {reduced_entry(0), reduced_entry(1)};
  const T beside = off.high + (off.low - (mean.low * gram[2] + towards[0] * tilt[1]));
  T difference = (a[0].high - a[1].high) +
                 ((a[0].low - a[1].low) -
                  (mean.low * (gram[0] - gram[1]) + (towards[0] * tilt[0] - towards[1] * tilt[1])));
  // Where the axes are not orthonormal, to first order: A − (gA + Ag)/2.
  difference = difference - (gram[0] * entry[0] - gram[1] * entry[1]);
  const T twice = 2 * beside - ((gram[0] + gram[1]) * beside + gram[2] * (entry[0] + entry[1]));

  ClosePair<T> r;
  r.middle = 0.5 * (entry[0] + entry[1]);
  r.difference = with_sign(root(difference * difference + twice * twice), difference);
  const T tangent = quotient(twice, difference + r.difference);
  const T cosine = 1 / root(1 + tangent * tangent);
  const T sine = cosine * tangent;
  for (int i = 0; i < 3; ++i) {
    T turned[2];
    for (int p = 0; p < 2; ++p)
      turned[p] = x.pair[p][i] -
                  (0.5 * (gram[p] * x.pair[p][i] + gram[2] * x.pair[1 - p][i]) + tilt[p] * x.separate[i]);
    r.frame.pair[0][i] = cosine * turned[0] + sine * turned[1];
    r.frame.pair[1][i] = cosine * turned[1] - sine * turned[0];
    T along = -0.5 * separate_gram * x.separate[i];
    for (int p = 0; p < 2; ++p) along = along + (tilt[p] - towards_gram[p]) * x.pair[p][i];
    r.frame.separate[i] = x.separate[i] + along;
  }
  return r;
}

/// Whether b − s 1 is a multiple of n nᵀ, exactly: its six minors are 0. Not found where a difference or b
/// itself takes two doubles.
template <class T>
RIGOR_INLINE Mask<T> is_rank_one(const SymmetricTensor<T>& b, T s) {
  auto holds = all<T>(0) == 0;
  DoubleDouble<T> d[3];
  for (int i = 0; i < 3; ++i) {
    d[i] = exact_difference(b.diagonal[i].high, s);
    holds = holds & (d[i].low == 0) & (b.diagonal[i].low == 0) & (b.off[i].low == 0);
  }
  const auto same = [&](T a, T c, T e, T f) RIGOR_INLINE_LAMBDA {
    const DoubleDouble<T> left = exact_product(a, c);
    const DoubleDouble<T> right = exact_product(e, f);
    return (left.high == right.high) & (left.low == right.low);
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    holds = holds & same(d[j].high, d[k].high, b.off[i].high, b.off[i].high) &
            same(d[i].high, b.off[i].high, b.off[j].high, b.off[k].high);
  }
  return holds;
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
