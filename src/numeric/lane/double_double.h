// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as the unevaluated sum of two doubles, about 106 bits, in one lane or in many. T is `double` or
// `Lanes`. Source: T. J. Dekker, Numer. Math. 18 (1971) 224; bounds: M. Joldes, J.-M. Muller, V. Popescu, ACM
// Trans. Math. Softw. 44 (2017) 15. Below, v = 2^-106. No operation branches; what overflows ends in NaN.
#pragma once

#include "numeric/lane/lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// high + low, |low| ≤ ½ unit in the last place of high (`normalised`) unless it says otherwise.
template <class T>
struct DoubleDouble {
  T high{};
  T low{};
};

/// a + b exactly. 6 operations.
template <class T>
RIGOR_INLINE DoubleDouble<T> exact_sum(T a, T b) {
  const T s = a + b;
  const T t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a − b exactly.
template <class T>
RIGOR_INLINE DoubleDouble<T> exact_difference(T a, T b) {
  const T s = a - b;
  const T t = s - a;
  return {s, (a - (s - t)) - (b + t)};
}

/// a + b exactly for |a| ≥ |b| or a = 0. 3 operations.
template <class T>
RIGOR_INLINE DoubleDouble<T> normalised(T a, T b) {
  const T s = a + b;
  return {s, b - (s - a)};
}

/// a b exactly, unless the low part underflows. 2 operations where there is a fused multiply-add, else 17.
template <class T>
RIGOR_INLINE DoubleDouble<T> exact_product(T a, T b) {
  const T p = a * b;
  return {p, rest_of_product(a, b, p)};
}

template <class T>
RIGOR_INLINE DoubleDouble<T> operator-(DoubleDouble<T> a) {
  return {-a.high, -a.low};
}

/// Relative error 3 v, also where a and b cancel. 20 operations.
template <class T>
RIGOR_INLINE DoubleDouble<T> operator+(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> high = exact_sum(a.high, b.high);
  const DoubleDouble<T> low = exact_sum(a.low, b.low);
  const DoubleDouble<T> sum = normalised(high.high, high.low + low.high);
  return normalised(sum.high, sum.low + low.low);
}
template <class T>
RIGOR_INLINE DoubleDouble<T> operator-(DoubleDouble<T> a, DoubleDouble<T> b) {
  return a + -b;
}

/// Relative error 2 v. 10 operations.
template <class T>
RIGOR_INLINE DoubleDouble<T> operator+(DoubleDouble<T> a, T b) {
  const DoubleDouble<T> high = exact_sum(a.high, b);
  return normalised(high.high, high.low + a.low);
}

/// The product, not normalised: the low part may be several units in the last place. 6 and 4 operations with
/// a fused multiply-add. For sums; the factors need not be normalised either.
template <class T>
RIGOR_INLINE DoubleDouble<T> raw_product(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> p = exact_product(a.high, b.high);
  return {p.high, p.low + (a.high * b.low + a.low * b.high)};
}
template <class T>
RIGOR_INLINE DoubleDouble<T> raw_product(DoubleDouble<T> a, T b) {
  const DoubleDouble<T> p = exact_product(a.high, b);
  return {p.high, p.low + a.low * b};
}

/// Relative error 7 v, and 3 v for a factor of one part.
template <class T>
RIGOR_INLINE DoubleDouble<T> operator*(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> p = raw_product(a, b);
  return normalised(p.high, p.low);
}
template <class T>
RIGOR_INLINE DoubleDouble<T> operator*(DoubleDouble<T> a, T b) {
  const DoubleDouble<T> p = raw_product(a, b);
  return normalised(p.high, p.low);
}

/// Relative error 15 v.
template <class T>
RIGOR_INLINE DoubleDouble<T> operator/(DoubleDouble<T> a, DoubleDouble<T> b) {
  const T q = a.high / b.high;
  const DoubleDouble<T> rest = a - b * q;
  return normalised(q, rest.high / b.high);
}

/// √a for a > 0 (0 for 0). Relative error 4 v.
template <class T>
RIGOR_INLINE DoubleDouble<T> root(DoubleDouble<T> a) {
  const T r = root(a.high);
  const DoubleDouble<T> rest = a - exact_product(r, r);
  return normalised(r, select(r > 0, rest.high / (2 * r), T{}));
}

/// A sum of numbers and products, not normalised until it is read. The error is v times the sum of the sizes
/// of the terms, times their number, at most: T. Ogita, S. M. Rump, S. Oishi, SIAM J. Sci. Comput. 26 (2005)
/// 1955.
template <class T>
struct CompensatedSum {
  T high{};
  T low{};

  /// 7 operations.
  RIGOR_INLINE void add(T x) {
    const DoubleDouble<T> s = exact_sum(high, x);
    high = s.high;
    low = low + s.low;
  }
  RIGOR_INLINE void add(DoubleDouble<T> x) {
    add(x.high);
    low = low + x.low;
  }
  RIGOR_INLINE void add_product(T a, T b) { add(exact_product(a, b)); }
  RIGOR_INLINE void add_product(DoubleDouble<T> a, T b) { add(raw_product(a, b)); }
  RIGOR_INLINE void add_product(DoubleDouble<T> a, DoubleDouble<T> b) { add(raw_product(a, b)); }
  /// |low| may be several units in the last place of high.
  [[nodiscard]] RIGOR_INLINE DoubleDouble<T> raw() const { return {high, low}; }
  [[nodiscard]] RIGOR_INLINE DoubleDouble<T> value() const { return exact_sum(high, low); }
};

/// The sum that has one term.
template <class T>
RIGOR_INLINE CompensatedSum<T> sum_of(DoubleDouble<T> first) {
  return {first.high, first.low};
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
