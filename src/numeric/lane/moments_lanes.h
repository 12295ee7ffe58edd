// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues of a symmetric 3×3 tensor, their gaps and eigenvectors, one tensor to a lane. T is `double` or
// `Lanes`.
//
// The textbook: eigenvalues q + 2p cos(θ + 2πk/3), gaps as their differences. Here:
// * a − s 1, s the middle one of the a_ii, entry by entry exactly in two parts, times a power of two: b;
// * S = MᵀbM in double-double, nearly diagonal, M a rotation exactly: `nearly_diagonal_lanes.h`;
// * the separate eigenvalue is decoupled to second order, the pair is a 2×2 problem whose gap √(δ² + 4o²)
//   has no cancellation.
// The absolute error of an eigenvalue is at most `proved_rounding` v |b|, v = 2^-106, and that of a gap at
// most twice that, for every tensor: moments_proof_test.cpp runs these templates on bounds instead of
// numbers. 61 v |a| was the worst in 1e5 tensors of all kinds. Where `moments_rounding` v is not small
// compared with the gap of the pair, `close_pair_lanes.h` takes the pair up again: to 2^-143, which is
// measured. What it finds is taken only if it agrees with what is proved to `agreement` v, so that the bound
// holds for it, too. Lanes in which a result is not good then say so: see `MomentsState`. Cost: some 730
// operations, 4 divisions and 6 roots; axes 100 more.
#pragma once

#include "numeric/lane/close_pair_lanes.h"
#include "numeric/lane/moments_columns.h"
#include "numeric/lane/nearly_diagonal_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

template <class T>
struct Eigensystem {
  DoubleDouble<T> values[3];  // ascending
  T gaps[2];                  // values[1] − values[0], values[2] − values[1]
  T axes[3][3];               // axes[k] is the unit vector to values[k]; right-handed
  T state;                    // see `MomentsState`
};

inline constexpr double moments_rounding = 64;
inline constexpr double proved_rounding = 16384;
/// How far, in v times the unit of b, `close_pair` may move an eigenvalue; both err by less than half of it.
inline constexpr double agreement = 256;
/// How large an eigenvalue or a gap must be compared with its absolute error: 8 u.
inline constexpr double good_beside = 0x1p-50;
/// Where S is less diagonal than that, terms of third order count: 2^-114 of b otherwise.
inline constexpr double nearly_diagonal = 0x1p-38;
/// The same for S₀₁, of which the gap of the pair is made: 2^-49.8 was the most in 2e7 tensors of all kinds.
inline constexpr double nearly_diagonal_pair = 0x1p-46;
/// A gap above this is the difference of the eigenvalues; below, it is known better than these are.
inline constexpr double close_gap = 0x1p-20;
/// Of |q|⁴ − 1: 24 u, unless something underflowed.
inline constexpr double most_excess = 0x1p-48;
/// Entries of b below this are left out: an error of 2^-150, and no product of theirs underflows.
inline constexpr double negligible = 0x1p-150;
/// The sizes of b between which neither its scale nor its eigenvalues leave the range of normal numbers.
inline constexpr double least_size = 0x1p-1010;
inline constexpr double greatest_size_solved = 0x1p1000;
/// Results are rounded to the last place there is when they are scaled back: 2^-1074, a few times.
inline constexpr double rounding_of_tiny = 0x1p-1070;

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

/// Eigenvalues of what is nearly diagonal, as S_kk and what is to be added; the gap of the first two; the
/// small angles of the axes.
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

/// The same, rounded once: `distinct_moments_lanes.h` finds these bits, too.
template <class T>
RIGOR_INLINE T rounded_difference(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> high = exact_difference(a.high, b.high);
  return high.high + (high.low + (a.low - b.low));
}

/// `s` is MᵀbM; M is `m`.
template <class T>
RIGOR_INLINE NearlyDiagonal<T> solved(const NearlyDiagonalTensor<T>& s, const Rotation<T>& m) {
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
  const T rest = greater(absolute(r.towards[0]), absolute(r.towards[1]));
  r.wrong =
      negation(rest < nearly_diagonal) | negation(absolute(s.pair) < nearly_diagonal_pair) | (rate == 0);
  const T less = m.excess - m.excess * m.excess;  // 1 − 1/|q|⁴
  for (DoubleDouble<T>& value : r.values) value.low = value.low - value.high * less;
  r.difference = r.difference - r.difference * less;
  return r;
}

/// The axes that these angles make of the columns of M.
template <class T>
RIGOR_INLINE Frame<T> frame_of(const Rotation<T>& m, const NearlyDiagonal<T>& d) {
  const T norm = 1 - 0.5 * m.excess;  // 1/|q|²
  const T cosine = 1 / root(1 + d.tangent * d.tangent);
  const T sine = cosine * d.tangent;
  Frame<T> f;
  for (int i = 0; i < 3; ++i) {
    const T x = m.at(0, i).high;
    const T y = m.at(1, i).high;
    const T z = m.at(2, i).high;
    const T turned_x = norm * (x + z * d.towards[0]);
    const T turned_y = norm * (y + z * d.towards[1]);
    f.separate[i] = norm * (z - (x * d.towards[0] + y * d.towards[1]));
    f.pair[0][i] = cosine * turned_x + sine * turned_y;
    f.pair[1][i] = cosine * turned_y - sine * turned_x;
  }
  return f;
}

/// In the order of the eigenvalues, first axes pointing to where their component of greatest size is
/// positive.
template <class T>
RIGOR_INLINE void set_axes(Eigensystem<T>& e, const Frame<T>& f, Mask<T> exchanged, Mask<T> separate_first) {
  for (int i = 0; i < 3; ++i) {
    const T low = select(exchanged, f.pair[1][i], f.pair[0][i]);
    const T high = select(exchanged, f.pair[0][i], f.pair[1][i]);
    e.axes[0][i] = select(separate_first, f.separate[i], low);
    e.axes[1][i] = select(separate_first, low, high);
    e.axes[2][i] = select(separate_first, high, f.separate[i]);
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

template <class T>
RIGOR_INLINE DoubleDouble<T> without_negligible(DoubleDouble<T> x) {
  return {select(absolute(x.high) < negligible, T{}, x.high), x.low};
}

template <class T>
RIGOR_INLINE T middle(T a, T b, T c) {
  const auto ordered = a < b;
  const T low = select(ordered, a, b);
  const T high = select(ordered, b, a);
  return select(c < low, low, select(c > high, high, c));
}

/// `sharp`: the low parts of `a` count.
template <bool sharp, class T>
RIGOR_INLINE Reduced<T> reduced(SymmetricTensor<T> a) {
  Reduced<T> r;
  r.shift = middle(a.diagonal[0].high, a.diagonal[1].high, a.diagonal[2].high);
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble<T> high = exact_difference(a.diagonal[i].high, r.shift);
    a.diagonal[i] = sharp ? high + a.diagonal[i].low : high;
  }
  const T size = greatest_size(a);
  r.power = power_below(size);
  const T factor = inverse_power(r.power);
  for (int i = 0; i < 3; ++i) {
    r.b.diagonal[i] = without_negligible(scaled<true>(a.diagonal[i], factor));
    r.b.off[i] = without_negligible(scaled<sharp>(a.off[i], factor));
  }
  r.wrong = negation(size >= least_size) | negation(size < greatest_size_solved) |
            negation(absolute(r.shift) < greatest_size_solved);
  return r;
}

template <class T, class M>
RIGOR_INLINE DoubleDouble<T> select(M mask, DoubleDouble<T> a, DoubleDouble<T> b) {
  return {select(mask, a.high, b.high), select(mask, a.low, b.low)};
}

/// Whether a is shift 1 + b power exactly.
template <class T>
RIGOR_INLINE Mask<T> is_exact(const Reduced<T>& r, const SymmetricTensor<T>& a) {
  auto holds = all<T>(0) == 0;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble<T> d = exact_difference(a.diagonal[i].high, r.shift);
    holds = holds & (a.diagonal[i].low == 0) & (a.off[i].low == 0) & (d.low == 0) &
            (d.high == r.b.diagonal[i].high * r.power) & (a.off[i].high == r.b.off[i].high * r.power);
  }
  return holds;
}

/// Of b, from a.
template <class T>
RIGOR_INLINE ExactDiagonal<T> exact_diagonal(const SymmetricTensor<T>& a, const Reduced<T>& r) {
  const T factor = inverse_power(r.power);
  ExactDiagonal<T> d;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble<T> high = exact_difference(a.diagonal[i].high, r.shift);
    d.first[i] = high.high * factor;
    d.second[i] = high.low * factor;
    d.third[i] = a.diagonal[i].low * factor;
  }
  return d;
}

/// The pair once more, where its gap is small: how well it is known then.
template <class T>
struct Sharpened {
  Mask<T> good;   // the gap stands out of the errors
  Mask<T> equal;  // the gap is 0, and the eigenvalues of the pair are exact
};

/// In the lanes of `small`; `frame` and `d` are replaced where that does better.
template <bool sharp, class T>
RIGOR_INLINE Sharpened<T> sharpen(const SymmetricTensor<T>& a, const Reduced<T>& r, Mask<T> small,
                                  NearlyDiagonal<T>& d, Frame<T>& frame) {
  DoubleDouble<T> mean = exact_sum(d.values[0].high, d.values[0].low);
  mean = mean + exact_sum(d.values[1].high, d.values[1].low);
  mean = {mean.high * 0.5, mean.low * 0.5};
  // An eigenvalue 0 is 0 but for rounding errors; it then takes one double, as the others do that take few
  // bits.
  const auto zero = absolute(mean.high) < 0x1p-98;
  mean = {select(zero, T{}, mean.high), select(zero, mean.high, mean.low)};
  const T apart = d.values[2].high - mean.high;
  const ClosePair<T> pair = close_pair<sharp>(exact_diagonal(a, r), r.b, frame, mean, apart);

  Sharpened<T> result;
  const auto usable = small & (absolute(apart) >= 0.25) & (absolute(d.difference) < nearly_diagonal_pair);
  result.good = usable & (absolute(pair.difference) * good_beside >= close_pair_rounding) &
                (absolute(pair.difference) * r.power * good_beside >= rounding_of_tiny);
  DoubleDouble<T> values[2];
  for (int p = 0; p < 2; ++p) {
    const T half = (p == 0 ? 0.5 : -0.5) * pair.difference;
    values[p] = {mean.high, mean.low + (pair.middle + half)};
    result.good =
        result.good & (absolute(difference_of(values[p], d.values[p])) <= all<T>(agreement * 0x1p-106));
  }
  result.equal = usable & negation(result.good);
  if (any(result.equal)) result.equal = result.equal & is_exact(r, a) & is_rank_one(r.b, mean.high);
  for (int p = 0; p < 2; ++p) {
    d.values[p] = select(result.good, values[p], d.values[p]);
    d.values[p] = select(result.equal, {mean.high, T{}}, d.values[p]);
    for (int i = 0; i < 3; ++i)
      frame.pair[p][i] = select(result.good, pair.frame.pair[p][i], frame.pair[p][i]);
  }
  for (int i = 0; i < 3; ++i)
    frame.separate[i] = select(result.good, pair.frame.separate[i], frame.separate[i]);
  d.difference = select(result.equal, T{}, select(result.good, pair.difference, d.difference));
  return result;
}

/// `s` is MᵀbM. `with_axes`: the axes are computed.
template <bool sharp, bool with_axes, class T>
RIGOR_INLINE Eigensystem<T> eigensystem(const SymmetricTensor<T>& a, const Reduced<T>& r,
                                        const Rotation<T>& m, const NearlyDiagonalTensor<T>& s) {
  NearlyDiagonal<T> d = solved(s, m);
  const T bound = all<T>(moments_rounding * 0x1p-106);
  auto small_gap =
      negation(absolute(d.difference) * r.power * good_beside >= bound * r.power + rounding_of_tiny);
  auto exact = all<T>(0) > 0;
  Frame<T> frame;
  if constexpr (with_axes) frame = frame_of(m, d);
  if (any(small_gap)) {
    if constexpr (!with_axes) frame = frame_of(m, d);
    const Sharpened<T> sharpened = sharpen<sharp>(a, r, small_gap, d, frame);
    exact = sharpened.equal;
    small_gap = small_gap & negation(sharpened.good | exact);
  }

  const auto exchanged = d.difference > 0;
  const auto separate_first = d.values[2].high < d.values[0].high;
  const T gap = absolute(
      select(absolute(d.difference) > close_gap, rounded_difference(d.values[0], d.values[1]), d.difference));
  auto small = all<T>(0) > 0;
  DoubleDouble<T> values[3];
  for (int k = 0; k < 3; ++k) {
    const DoubleDouble<T> v = d.values[k];
    const DoubleDouble<T> sum = exact_sum(r.shift, v.high * r.power);
    values[k] = normalised(sum.high, sum.low + v.low * r.power);
    const auto lost = negation(absolute(values[k].high) * good_beside >=
                               bound * (r.power + absolute(r.shift)) + rounding_of_tiny);
    small = small | (k < 2 ? lost & negation(exact) : lost);
  }
  const DoubleDouble<T> low = select(exchanged, values[1], values[0]);
  const DoubleDouble<T> high = select(exchanged, values[0], values[1]);
  const T other = absolute(
      rounded_difference(d.values[2], select(exchanged != separate_first, d.values[0], d.values[1])));
  Eigensystem<T> e;
  e.gaps[0] = select(separate_first, other, gap) * r.power;
  e.gaps[1] = select(separate_first, gap, other) * r.power;
  e.values[0] = select(separate_first, values[2], low);
  e.values[1] = select(separate_first, low, high);
  e.values[2] = select(separate_first, high, values[2]);
  e.state = select(small_gap, all<T>(MomentsState::small_gap), T{}) +
            select(small, all<T>(MomentsState::small_moment), T{});
  const auto wrong = r.wrong | d.wrong | negation(absolute(m.excess) < most_excess);
  e.state = select(wrong, all<T>(MomentsState::lost), e.state);
  if constexpr (with_axes) set_axes(e, frame, exchanged, separate_first);
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

template <bool sharp, bool with_axes, class T>
RIGOR_INLINE Eigensystem<T> solved_of(const SymmetricTensor<T>& a) {
  const Reduced<T> r = reduced<sharp>(a);
  const Rotation<T> m = rotation_of(nearly_diagonalising(r.b));
  return eigensystem<sharp, with_axes>(a, r, m, transformed<sharp>(r.b, m));
}

/// The tensors from `at` on, as many as T holds.
template <bool sharp, bool with_axes, class T>
RIGOR_INLINE void solve_at(const MomentsColumns& c, std::size_t at) {
  store_at<with_axes>(c, at, solved_of<sharp, with_axes>(tensor_at<sharp, T>(c, at)));
}

template <bool sharp, bool with_axes>
double solve_one(const double* tensor, double* moments, double* gaps, double* axes) {
  const auto entry = [&](int at) RIGOR_INLINE_LAMBDA {
    if constexpr (sharp)
      return DoubleDouble<double>{tensor[2 * at], tensor[2 * at + 1]};
    else
      return DoubleDouble<double>{tensor[at], 0};
  };
  const SymmetricTensor<double> a{{entry(0), entry(4), entry(8)}, {entry(7), entry(6), entry(3)}};
  const Eigensystem<double> e = solved_of<sharp, with_axes>(a);
  for (int k = 0; k < 3; ++k) {
    moments[2 * k] = e.values[k].high;
    moments[2 * k + 1] = e.values[k].low;
    for (int i = 0; with_axes && i < 3; ++i) axes[3 * k + i] = e.axes[k][i];
  }
  for (int k = 0; k < 2; ++k) gaps[k] = e.gaps[k];
  return e.state;
}

inline double principal_moments_of_one(const double* tensor, bool sharp, double* moments, double* gaps,
                                       double* axes) {
  if (axes != nullptr)
    return (sharp ? solve_one<true, true> : solve_one<false, true>)(tensor, moments, gaps, axes);
  return (sharp ? solve_one<true, false> : solve_one<false, false>)(tensor, moments, gaps, axes);
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
