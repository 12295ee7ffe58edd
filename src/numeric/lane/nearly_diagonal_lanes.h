// SPDX-License-Identifier: GPL-3.0-or-later
// An orthogonal similarity that makes a symmetric 3×3 tensor nearly diagonal, exactly a similarity.
//
// * In plain doubles, a quaternion q of axes: the eigenvector of the most separate eigenvalue from the
// largest
//   column of the adjugate, then one rotation about it.
// * M(q), the rotation matrix times |q|², has MᵀM = |q|⁴ 1 for any q, so that S = MᵀbM in double-double has
//   the eigenvalues of b times |q|⁴, whatever the first step got wrong: it only leaves S less diagonal.
// Sources: D. Eberly, A Robust Eigensolver for 3 × 3 Symmetric Matrices (2014), for the first step; T. Ogita,
// K. Aishima, Japan J. Indust. Appl. Math. 35 (2018) 1007, refine eigenvectors likewise, without the
// quaternion.
#pragma once

#include "numeric/lane/double_double.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// Diagonal a_ii, and off it a_jk for the cyclic (i, j, k).
template <class T>
struct SymmetricTensor {
  DoubleDouble<T> diagonal[3];
  DoubleDouble<T> off[3];
};

template <class T>
struct Quaternion {
  T w, x, y, z;
};

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
  // In pairs, and pairs of pairs, which do not wait for each other.
  const T square = r * r;
  const T fourth = square * square;
  T pairs[7];
  for (int k = 0; k < 7; ++k) pairs[k] = coefficients[2 * k] + coefficients[2 * k + 1] * r;
  T fours[3];
  for (int k = 0; k < 3; ++k) fours[k] = pairs[2 * k] + pairs[2 * k + 1] * square;
  return (fours[0] + fours[1] * fourth) + (fours[2] + pairs[6] * fourth) * (fourth * fourth);
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
  const T inverse = quotient(all<T>(1), squares);            // of 6p², beside the root and not behind it
  const T r = (determinant * inverse) * (inverse * p * 18);  // det/(2 p³)
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
  // With H = √(towards² + ef²) = √(2 l towards) the square of q is 4 |axis| h H (towards + H).
  const T half = (ee - ff) * 0.5;
  const T hypotenuse = root(half * half + ef * ef);
  const T towards = absolute(half) + hypotenuse;
  const T sum_length = root(2 * (hypotenuse * towards));
  const T cosine = towards + sum_length;
  const T sine = with_sign(all<T>(1), half) * ef;
  const auto round = cosine == 0;
  const T w = select(round, all<T>(1), cosine);
  const T square = 4 * (length * h) * select(round, all<T>(0.5), sum_length * w);
  const T norm = quotient(all<T>(1), root(square));
  return {(h * w) * norm, (x * sine - y * w) * norm, (x * w + y * sine) * norm, (h * sine) * norm};
}

/// The rotation matrix of q times |q|², by columns, and |q|⁴ − 1.
template <class T>
struct Rotation {
  DoubleDouble<T> column[3][3];
  T excess;

  /// Component i of a column.
  [[nodiscard]] RIGOR_INLINE DoubleDouble<T> at(int of, int i) const { return column[of][i]; }
};
/// Of one tensor: a component of all columns at once, and of the first once more.
template <>
struct Rotation<double> {
  DoubleDouble<Quad> across[3];
  double excess;

  [[nodiscard]] RIGOR_INLINE DoubleDouble<double> at(int of, int i) const {
    return {across[i].high[of], across[i].low[of]};
  }
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

template <int i, int j, int k, int l>
RIGOR_INLINE DoubleDouble<Quad> parts(const DoubleDouble<Quad>& a, const DoubleDouble<Quad>& b) {
  return {parts<i, j, k, l>(a.high, b.high), parts<i, j, k, l>(a.low, b.low)};
}

/// The same operations, four at once.
RIGOR_INLINE Rotation<double> rotation_of(const Quaternion<double>& q) {
  using Four = DoubleDouble<Quad>;
  const auto with_signs = [](const Four& x, Quad signs) RIGOR_INLINE_LAMBDA {
    return Four{x.high * signs, x.low * signs};
  };
  const Quad v = quad(q.x, q.y, q.z, q.w);
  const Four products = exact_product(2 * v, parts<1, 2, 0, 3>(v, v));            // 2xy, 2yz, 2zx
  const Four turns = exact_product(all<Quad>(2 * q.w), parts<2, 0, 1, 3>(v, v));  // 2wz, 2wx, 2wy
  const Four squares = exact_product(v, v);
  const Four above = raw_sum(products, turns);
  const Four below = raw_sum(products, -turns);
  // w² + z², x² + y², w² − z², x² − y²; and of them the diagonal and |q|².
  const Four pairs = raw_sum(parts<3, 0, 3, 0>(squares, squares),
                             with_signs(parts<2, 1, 2, 1>(squares, squares), quad(1, 1, -1, -1)));
  const Four diagonal = raw_sum(parts<2, 2, 0, 0>(pairs, pairs),
                                with_signs(parts<3, 3, 1, 1>(pairs, pairs), quad(1, -1, -1, 1)));
  const double e = (diagonal.high[3] - 1) + diagonal.low[3];
  return {{parts<0, 1, 6, 3>(parts<0, 4, 0, 0>(diagonal, below), above),
           parts<0, 1, 5, 3>(parts<0, 5, 0, 0>(above, diagonal), below),
           parts<0, 1, 6, 3>(parts<2, 5, 0, 2>(below, above), diagonal)},
          2 * e + e * e};
}

/// MᵀbM, which is diagonal but for small numbers: S₀₁, and S₀₂ and S₁₂. Nothing is normalised.
template <class T>
struct NearlyDiagonalTensor {
  DoubleDouble<T> diagonal[3];
  T pair;
  T separate[2];
};

/// Of one tensor: the same operations, three columns and the product of the first two at once.
template <bool sharp>
RIGOR_INLINE NearlyDiagonalTensor<double> transformed(const SymmetricTensor<double>& b,
                                                      const Rotation<double>& m) {
  using Both = DoubleDouble<Quad>;
  const auto everywhere = [](DoubleDouble<double> x) RIGOR_INLINE_LAMBDA {
    return Both{all<Quad>(x.high), all<Quad>(x.low)};
  };
  const Both* const left = m.across;
  Both right[3];
  for (int l = 0; l < 3; ++l) right[l] = parts<0, 1, 2, 1>(left[l], left[l]);
  Both bm[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    CompensatedSum<Quad> sum = sum_of(raw_product(right[i], everywhere(b.diagonal[i])));
    if constexpr (sharp) {
      sum.add(raw_product(right[j], everywhere(b.off[k])));
      sum.add(raw_product(right[k], everywhere(b.off[j])));
    } else {
      sum.add(raw_product(right[j], all<Quad>(b.off[k].high)));
      sum.add(raw_product(right[k], all<Quad>(b.off[j].high)));
    }
    bm[i] = sum.raw();
  }
  CompensatedSum<Quad> products = sum_of(raw_product(left[0], bm[0]));
  for (int l = 1; l < 3; ++l) products.add(raw_product(left[l], bm[l]));
  NearlyDiagonalTensor<double> s;
  for (int i = 0; i < 3; ++i) s.diagonal[i] = {products.high[i], products.low[i]};
  s.pair = products.high[3] + products.low[3];
  s.separate[0] = 0;
  s.separate[1] = 0;
  for (int l = 0; l < 3; ++l) {
    const DoubleDouble<double> along = exact_product(m.at(2, l).high, s.diagonal[2].high);
    const double rest =
        (bm[l].high[2] - along.high) + (bm[l].low[2] - (along.low + m.at(2, l).low * s.diagonal[2].high));
    for (int i = 0; i < 2; ++i) s.separate[i] = s.separate[i] + m.at(i, l).high * rest;
  }
  return s;
}

template <bool sharp, class T>
RIGOR_INLINE NearlyDiagonalTensor<T> transformed(const SymmetricTensor<T>& b, const Rotation<T>& m) {
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

}  // namespace rigor::RIGOR_INSTRUCTION_SET
