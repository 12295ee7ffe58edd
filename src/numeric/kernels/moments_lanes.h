// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues of a symmetric 3×3 tensor, their gaps and eigenvectors, one tensor to a lane. T is `double` or
// `Lanes`.
//
// The textbook: eigenvalues q + 2p cos(θ + 2πk/3), gaps as their differences. Here:
//   1. a − s 1, s ≈ tr(a)/3, entry by entry exactly in two parts; both scaled by powers of two;
//   2. in plain doubles, a quaternion of axes that make it nearly diagonal: the eigenvector of the most
//   separate
//      eigenvalue from the largest column of the adjugate, then one rotation about it;
//   3. M(q), the rotation matrix times |q|², has MᵀM = |q|⁴ 1 exactly, so that S = MᵀbM in double-double has
//   the
//      eigenvalues of b times |q|⁴, whatever step 2 got wrong;
//   4. S is diagonal to about 2^-40: the separate eigenvalue is decoupled to second order, the pair is a 2×2
//   problem
//      whose gap √(δ² + 4o²) has no cancellation.
// The absolute error of eigenvalues and gaps is at most `moments_rounding` v |b|, v = 2^-106; lanes in which
// that is not small beside a result are marked, and so is what overflows or is not a number: see
// `principal_moments.h`. Source for 2: D. Eberly, A Robust Eigensolver for 3 × 3 Symmetric Matrices (2014),
// and the cubic's real root; for 3: T. Ogita, K. Aishima, Japan J. Indust. Appl. Math. 35 (2018) 1007 refine
// likewise, without the quaternion.
#pragma once

#include "numeric/kernels/double_double.h"
#include "numeric/kernels/moments_columns.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// Diagonal a_ii, and beside it a_jk for the cyclic (i, j, k).
template <class T>
struct SymmetricTensor {
  DoubleDouble<T> diagonal[3];
  DoubleDouble<T> off[3];
};

template <class T>
struct Quaternion {
  T w, x, y, z;
};

template <class T>
struct Eigensystem {
  DoubleDouble<T> values[3];  // ascending
  T gaps[2];                  // values[1] − values[0], values[2] − values[1]
  T axes[3][3];               // axes[k] is the unit vector to values[k]; right-handed
  T state;                    // 0, or what is wrong: see `MomentsColumns`
};

inline constexpr double moments_rounding = 64;

template <class T>
RIGOR_INLINE T greatest_size(const SymmetricTensor<T>& a) {
  T m = absolute(a.diagonal[0].high);
  for (int i = 1; i < 3; ++i) m = greater(absolute(a.diagonal[i].high), m);
  for (int i = 0; i < 3; ++i) m = greater(absolute(a.off[i].high), m);
  return m;
}

/// `sharp`: with the low part.
template <bool sharp, class T>
RIGOR_INLINE DoubleDouble<T> scaled(DoubleDouble<T> a, T factor) {
  return {a.high * factor, sharp ? a.low * factor : a.low};
}

/// a / b, and 0 where b is 0.
template <class T>
RIGOR_INLINE T quotient(T a, T b) {
  return select(b == 0, b, a / b);
}

/// 2 cos(arccos(r)/3) for 0 ≤ r ≤ 1, the greatest root of β³ − 3β = 2r, to 3e-13: the polynomial of degree 13
/// through the Chebyshev points.
template <class T>
RIGOR_INLINE T greatest_cubic_root(T r) {
  constexpr double coefficients[] = {1.7320508075691519,     0.33333333322423364,    -0.09622503767726746,
                                     0.04938252799049257,    -0.03118144813179973,   0.021926159068763287,
                                     -0.016396215571246233,  0.012546952478520064,   -0.00931458308800107,
                                     0.00622126514021407,    -0.0034123422145577414, 0.001383040549366602,
                                     -0.0003582296360816274, 4.377029836177826e-05};
  const T square = r * r;
  T even = all<T>(coefficients[12]);
  T odd = all<T>(coefficients[13]);
  for (int k = 10; k >= 0; k -= 2) {
    even = even * square + coefficients[k];
    odd = odd * square + coefficients[k + 1];
  }
  return even + odd * r;
}

/// The deviator of a tensor in plain doubles, and the eigenvector of the eigenvalue that is most separate
/// from the others; not normalised, with z ≥ 0.
template <class T>
struct Separate {
  T diagonal[3];
  T off[3];
  T axis[3];
};

template <class T>
RIGOR_INLINE Separate<T> separate_axis(const SymmetricTensor<T>& b) {
  Separate<T> c;
  const T mean = (b.diagonal[0].high + b.diagonal[1].high + b.diagonal[2].high) * (1. / 3);
  T squares = T{};
  for (int i = 0; i < 3; ++i) {
    c.diagonal[i] = b.diagonal[i].high - mean;
    c.off[i] = b.off[i].high;
    squares = squares + (c.diagonal[i] * c.diagonal[i] + 2 * (c.off[i] * c.off[i]));
  }
  const T p = root(squares * (1. / 6));  // eigenvalues p (2 cos …)
  T determinant = 2 * (c.off[0] * c.off[1] * c.off[2]) + c.diagonal[0] * c.diagonal[1] * c.diagonal[2];
  for (int i = 0; i < 3; ++i) determinant = determinant - c.diagonal[i] * (c.off[i] * c.off[i]);
  const T r = quotient(determinant * 3, squares * p);  // det/(2 p³)
  const T value = with_sign(greatest_cubic_root(absolute(r)) * p, r);

  T d[3];
  for (int i = 0; i < 3; ++i) d[i] = c.diagonal[i] - value;
  // adj(c − value 1) = κ n nᵀ with κ > 0: the column with the largest diagonal entry.
  T adjugate_diagonal[3];
  T adjugate_off[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    adjugate_diagonal[i] = d[j] * d[k] - c.off[i] * c.off[i];
    adjugate_off[i] = c.off[j] * c.off[k] - d[i] * c.off[i];
  }
  T best = adjugate_diagonal[0];
  c.axis[0] = adjugate_diagonal[0];
  c.axis[1] = adjugate_off[2];
  c.axis[2] = adjugate_off[1];
  for (int i = 1; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto larger = adjugate_diagonal[i] > best;
    best = select(larger, adjugate_diagonal[i], best);
    c.axis[i] = select(larger, adjugate_diagonal[i], c.axis[i]);
    c.axis[j] = select(larger, adjugate_off[k], c.axis[j]);
    c.axis[k] = select(larger, adjugate_off[j], c.axis[k]);
  }
  const T sign = with_sign(all<T>(1), c.axis[2]);
  for (int i = 0; i < 3; ++i) c.axis[i] = c.axis[i] * sign;
  return c;
}

/// A unit quaternion, to rounding, of the rotation that carries z to the separate axis and x, y to the other
/// two.
template <class T>
RIGOR_INLINE Quaternion<T> nearly_diagonalising(const SymmetricTensor<T>& b) {
  const Separate<T> c = separate_axis(b);
  const T x = c.axis[0];
  const T y = c.axis[1];
  const T length = root(x * x + y * y + c.axis[2] * c.axis[2]);
  const T h = length + c.axis[2];
  // Of length l h, orthogonal to the axis and to each other: what (h, −y, x, 0) carries x and y to.
  const T e[3] = {length * h - x * x, -(x * y), -(x * h)};
  const T f[3] = {e[1], length * h - y * y, -(y * h)};
  T ee = T{};
  T ef = T{};
  T ff = T{};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const T ce = c.diagonal[i] * e[i] + (c.off[k] * e[j] + c.off[j] * e[k]);
    const T cf = c.diagonal[i] * f[i] + (c.off[k] * f[j] + c.off[j] * f[k]);
    ee = ee + e[i] * ce;
    ef = ef + e[i] * cf;
    ff = ff + f[i] * cf;
  }
  // φ, |φ| ≤ π/4, is the rotation about the axis that makes ef vanish: (|half| + l, ef) has the direction φ,
  // where l = √(half² + ef²), and its sum with its length along x has the direction φ/2.
  const T half = (ee - ff) * 0.5;
  const T towards = absolute(half) + root(half * half + ef * ef);
  const T cosine = towards + root(towards * towards + ef * ef);
  const T sine = with_sign(all<T>(1), half) * ef;
  const auto round = cosine == 0;
  const T w = select(round, all<T>(1), cosine);
  const Quaternion<T> q = {h * w, x * sine - y * w, x * w + y * sine, h * sine};
  const T norm = quotient(all<T>(1), root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z));
  return {q.w * norm, q.x * norm, q.y * norm, q.z * norm};
}

/// The rotation matrix of q times |q|², by columns, and |q|⁴ − 1.
template <class T>
struct Rotation {
  DoubleDouble<T> column[3][3];
  T excess;
};

/// Not normalised.
template <class T>
RIGOR_INLINE DoubleDouble<T> raw_sum(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> s = exact_sum(a.high, b.high);
  return {s.high, s.low + (a.low + b.low)};
}

template <class T>
RIGOR_INLINE Rotation<T> rotation_of(const Quaternion<T>& q) {
  const T v[3] = {q.x, q.y, q.z};
  Rotation<T> m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const DoubleDouble<T> product = exact_product(2 * v[i], v[j]);
    const DoubleDouble<T> turn = exact_product(2 * q.w, v[k]);
    m.column[i][j] = raw_sum(product, turn);
    m.column[j][i] = raw_sum(product, -turn);
  }
  const DoubleDouble<T> ww = exact_product(q.w, q.w);
  const DoubleDouble<T> xx = exact_product(q.x, q.x);
  const DoubleDouble<T> yy = exact_product(q.y, q.y);
  const DoubleDouble<T> zz = exact_product(q.z, q.z);
  const DoubleDouble<T> w_and_z = raw_sum(ww, zz);
  const DoubleDouble<T> w_less_z = raw_sum(ww, -zz);
  const DoubleDouble<T> x_and_y = raw_sum(xx, yy);
  const DoubleDouble<T> x_less_y = raw_sum(xx, -yy);
  m.column[0][0] = raw_sum(w_less_z, x_less_y);
  m.column[1][1] = raw_sum(w_less_z, -x_less_y);
  m.column[2][2] = raw_sum(w_and_z, -x_and_y);
  const DoubleDouble<T> norm = raw_sum(w_and_z, x_and_y);
  const T e = (norm.high - 1) + norm.low;
  m.excess = 2 * e + e * e;
  return m;
}

/// MᵀbM, which is diagonal but for small numbers: S₀₁, and S₀₂ and S₁₂. Nothing is normalised.
template <class T>
struct NearlyDiagonalTensor {
  DoubleDouble<T> diagonal[3];
  T pair;
  T separate[2];
};

template <bool sharp, class T>
RIGOR_INLINE NearlyDiagonalTensor<T> similar(const SymmetricTensor<T>& b, const Rotation<T>& m) {
  DoubleDouble<T> bm[3][3];  // by columns
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      CompensatedSum<T> sum = sum_of(raw_product(m.column[c][i], b.diagonal[i]));
      if constexpr (sharp) {
        sum.add(raw_product(m.column[c][j], b.off[k]));
        sum.add(raw_product(m.column[c][k], b.off[j]));
      } else {
        sum.add(raw_product(m.column[c][j], b.off[k].high));
        sum.add(raw_product(m.column[c][k], b.off[j].high));
      }
      bm[c][i] = sum.raw();
    }
  }
  const auto product_of = [&](int i, int j) RIGOR_INLINE_LAMBDA {
    CompensatedSum<T> sum = sum_of(raw_product(m.column[i][0], bm[j][0]));
    for (int l = 1; l < 3; ++l) sum.add(raw_product(m.column[i][l], bm[j][l]));
    return sum.raw();
  };
  NearlyDiagonalTensor<T> s;
  for (int i = 0; i < 3; ++i) s.diagonal[i] = product_of(i, i);
  const DoubleDouble<T> off = product_of(0, 1);
  s.pair = off.high + off.low;
  // The columns of M are orthogonal, so that mᵢ·b m₂ = mᵢ·(b m₂ − λ m₂), which is small where λ is S₂₂.
  s.separate[0] = T{};
  s.separate[1] = T{};
  for (int l = 0; l < 3; ++l) {
    const DoubleDouble<T> along = exact_product(m.column[2][l].high, s.diagonal[2].high);
    const T rest =
        (bm[2][l].high - along.high) + (bm[2][l].low - (along.low + m.column[2][l].low * s.diagonal[2].high));
    for (int i = 0; i < 2; ++i) s.separate[i] = s.separate[i] + m.column[i][l].high * rest;
  }
  return s;
}

/// Eigenvalues of what is nearly diagonal, still times |q|⁴, as S_kk and what is to be added; the gap of the
/// first two; the small angles of the axes.
template <class T>
struct NearlyDiagonal {
  DoubleDouble<T> values[3];
  T difference;   // of the first two, signed; its size is the gap
  T tangent;      // of the rotation of column 0 towards column 1
  T towards[2];   // how far columns 0 and 1 turn towards column 2
  Mask<T> wrong;  // not nearly diagonal
};

template <class T>
RIGOR_INLINE T difference_of(DoubleDouble<T> a, DoubleDouble<T> b) {
  return (a.high - b.high) + (a.low - b.low);
}

template <class T>
RIGOR_INLINE NearlyDiagonal<T> solved(const NearlyDiagonalTensor<T>& s) {
  NearlyDiagonal<T> r;
  const T apart[2] = {s.diagonal[0].high - s.diagonal[2].high, s.diagonal[1].high - s.diagonal[2].high};
  const T rate = quotient(all<T>(1), apart[0] * apart[1]);
  T shift[2];
  for (int i = 0; i < 2; ++i) {
    r.towards[i] = s.separate[i] * (apart[1 - i] * rate);
    shift[i] = s.separate[i] * r.towards[i];
  }
  const T twice = 2 * s.pair + (s.separate[0] * r.towards[1] + s.separate[1] * r.towards[0]);  // 2o
  const T difference = difference_of(s.diagonal[0], s.diagonal[1]) + (shift[0] - shift[1]);    // δ
  r.difference = with_sign(root(difference * difference + twice * twice), difference);
  r.tangent = quotient(twice, difference + r.difference);
  // (gap − |δ|)/2 without cancellation, with the sign of δ.
  const T outwards = r.tangent * twice * 0.5;
  const T more[3] = {shift[0] + outwards, shift[1] - outwards, -(shift[0] + shift[1])};
  for (int i = 0; i < 3; ++i) r.values[i] = {s.diagonal[i].high, s.diagonal[i].low + more[i]};
  // The terms left out are of third order in what is not diagonal: 2^-114.
  const T rest = greater(greater(absolute(r.towards[0]), absolute(r.towards[1])), absolute(s.pair));
  r.wrong = negation(rest < 0x1p-38) | (rate == 0);
  return r;
}

/// In the order of the eigenvalues, first axes pointing to where their component of greatest size is
/// positive.
template <class T>
RIGOR_INLINE void set_axes(Eigensystem<T>& e, const Rotation<T>& m, const NearlyDiagonal<T>& d,
                           Mask<T> exchanged, Mask<T> separate_first) {
  const T norm = 1 - 0.5 * m.excess;  // 1/|q|²
  const T cosine = 1 / root(1 + d.tangent * d.tangent);
  const T sine = cosine * d.tangent;
  T pair[2][3];
  T separate[3];
  for (int i = 0; i < 3; ++i) {
    const T x = m.column[0][i].high;
    const T y = m.column[1][i].high;
    const T z = m.column[2][i].high;
    const T turned_x = norm * (x + z * d.towards[0]);
    const T turned_y = norm * (y + z * d.towards[1]);
    separate[i] = norm * (z - (x * d.towards[0] + y * d.towards[1]));
    pair[0][i] = cosine * turned_x + sine * turned_y;
    pair[1][i] = cosine * turned_y - sine * turned_x;
  }
  for (int i = 0; i < 3; ++i) {
    const T low = select(exchanged, pair[1][i], pair[0][i]);
    const T high = select(exchanged, pair[0][i], pair[1][i]);
    e.axes[0][i] = select(separate_first, separate[i], low);
    e.axes[1][i] = select(separate_first, low, high);
    e.axes[2][i] = select(separate_first, high, separate[i]);
  }
  for (int k = 0; k < 2; ++k) {
    T peak = e.axes[k][0];
    for (int i = 1; i < 3; ++i) peak = select(absolute(e.axes[k][i]) > absolute(peak), e.axes[k][i], peak);
    const T sign = with_sign(all<T>(1), peak);
    for (int i = 0; i < 3; ++i) e.axes[k][i] = e.axes[k][i] * sign;
  }
  T handed = T{};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    handed = handed + e.axes[2][i] * (e.axes[0][j] * e.axes[1][k] - e.axes[0][k] * e.axes[1][j]);
  }
  const T sign = with_sign(all<T>(1), handed);
  for (int i = 0; i < 3; ++i) e.axes[2][i] = e.axes[2][i] * sign;
}

/// What is solved instead of a tensor: b = (a − shift 1)/power, with a greatest entry of 1 to 2.
template <class T>
struct Reduced {
  SymmetricTensor<T> b;
  T shift;
  T power;
  Mask<T> wrong;  // a or b is 0, not finite, or out of the range in which nothing overflows or gets lost
};

/// `sharp`: the low parts of `a` count.
template <bool sharp, class T>
RIGOR_INLINE Reduced<T> reduced(SymmetricTensor<T> a) {
  Reduced<T> r;
  r.shift = (a.diagonal[0].high + a.diagonal[1].high + a.diagonal[2].high) * (1. / 3);
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble<T> high = exact_difference(a.diagonal[i].high, r.shift);
    a.diagonal[i] = sharp ? high + a.diagonal[i].low : high;
  }
  const T size = greatest_size(a);
  r.power = power_below(size);
  const T factor = inverse_power(r.power);
  for (int i = 0; i < 3; ++i) {
    r.b.diagonal[i] = scaled<true>(a.diagonal[i], factor);
    r.b.off[i] = scaled<sharp>(a.off[i], factor);
  }
  r.wrong = negation(size >= 0x1p-1010) | negation(size < 0x1p1000) | negation(absolute(r.shift) < 0x1p1000);
  return r;
}

template <class T, class M>
RIGOR_INLINE DoubleDouble<T> select(M mask, DoubleDouble<T> a, DoubleDouble<T> b) {
  return {select(mask, a.high, b.high), select(mask, a.low, b.low)};
}

/// `s` is MᵀbM. `with_axes`: the axes are computed.
template <bool with_axes, class T>
RIGOR_INLINE Eigensystem<T> eigensystem(const Reduced<T>& r, const Rotation<T>& m,
                                        const NearlyDiagonalTensor<T>& s) {
  const NearlyDiagonal<T> d = solved(s);
  const auto exchanged = d.difference > 0;
  const auto separate_first = d.values[2].high < d.values[0].high;
  const DoubleDouble<T> low = select(exchanged, d.values[1], d.values[0]);
  const DoubleDouble<T> high = select(exchanged, d.values[0], d.values[1]);
  const T gap = absolute(d.difference);
  const T other = absolute(difference_of(d.values[2], select(separate_first, low, high)));
  Eigensystem<T> e;
  e.gaps[0] = select(separate_first, other, gap);
  e.gaps[1] = select(separate_first, gap, other);
  e.values[0] = select(separate_first, d.values[2], low);
  e.values[1] = select(separate_first, low, high);
  e.values[2] = select(separate_first, high, d.values[2]);

  constexpr double good = 0x1p-50;                // 8 u
  const T less = m.excess - m.excess * m.excess;  // 1 − 1/|q|⁴
  const T bound = all<T>(moments_rounding * 0x1p-106);
  constexpr double least = 0x1p-1070;  // where products are rounded to the last place there is
  auto small = all<T>(0) > 0;
  for (int k = 0; k < 3; ++k) {
    const DoubleDouble<T> v = e.values[k];
    const DoubleDouble<T> sum = exact_sum(r.shift, v.high * r.power);
    e.values[k] = normalised(sum.high, sum.low + (v.low - v.high * less) * r.power);
    small =
        small | negation(absolute(e.values[k].high) * good >= bound * (r.power + absolute(r.shift)) + least);
  }
  for (int k = 0; k < 2; ++k) e.gaps[k] = (e.gaps[k] - e.gaps[k] * less) * r.power;
  e.state = select(negation(gap * r.power * good >= bound * r.power + least), all<T>(1), T{}) +
            select(small, all<T>(2), T{});
  e.state = select(r.wrong | d.wrong, all<T>(4), e.state);
  if constexpr (with_axes) set_axes(e, m, d, exchanged, separate_first);
  return e;
}

template <class T>
RIGOR_INLINE T load_as(const double* from);
template <>
RIGOR_INLINE double load_as<double>(const double* from) {
  return *from;
}
template <>
RIGOR_INLINE Lanes load_as<Lanes>(const double* from) {
  return load(from);
}
RIGOR_INLINE void store(double* to, double x) { *to = x; }

template <bool sharp, class T>
RIGOR_INLINE SymmetricTensor<T> tensor_at(const MomentsColumns& c, std::size_t at) {
  SymmetricTensor<T> a;
  for (int i = 0; i < 3; ++i) {
    a.diagonal[i].high = load_as<T>(c.diagonal[i] + at);
    a.off[i].high = load_as<T>(c.off[i] + at);
    if constexpr (sharp) {
      a.diagonal[i].low = load_as<T>(c.diagonal_low[i] + at);
      a.off[i].low = load_as<T>(c.off_low[i] + at);
    }
  }
  return a;
}

template <bool with_axes, class T>
RIGOR_INLINE void store_at(const MomentsColumns& c, std::size_t at, const Eigensystem<T>& e) {
  for (int k = 0; k < 3; ++k) {
    store(c.moments[k] + at, e.values[k].high);
    if (c.moments_low[k] != nullptr) store(c.moments_low[k] + at, e.values[k].low);
    if constexpr (with_axes) {
      for (int i = 0; i < 3; ++i) store(c.axes[k][i] + at, e.axes[k][i]);
    }
  }
  for (int k = 0; k < 2; ++k) store(c.gaps[k] + at, e.gaps[k]);
  store(c.state + at, e.state);
}

/// The tensors from `at` on, as many as T holds.
template <bool sharp, bool with_axes, class T>
RIGOR_INLINE void solve_at(const MomentsColumns& c, std::size_t at) {
  const Reduced<T> r = reduced<sharp>(tensor_at<sharp, T>(c, at));
  const Rotation<T> m = rotation_of(nearly_diagonalising(r.b));
  store_at<with_axes>(c, at, eigensystem<with_axes>(r, m, similar<sharp>(r.b, m)));
}

template <bool sharp, bool with_axes>
void solve_all(const MomentsColumns& c) {
  std::size_t at = 0;
  for (; at + lanes <= c.count; at += lanes) solve_at<sharp, with_axes, Lanes>(c, at);
  for (; at < c.count; ++at) solve_at<sharp, with_axes, double>(c, at);
}

inline void principal_moments_kernel(const MomentsColumns& c) {
  const bool sharp = c.diagonal_low[0] != nullptr;
  if (c.axes[0][0] == nullptr) {
    sharp ? solve_all<true, false>(c) : solve_all<false, false>(c);
  } else {
    sharp ? solve_all<true, true>(c) : solve_all<false, true>(c);
  }
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
