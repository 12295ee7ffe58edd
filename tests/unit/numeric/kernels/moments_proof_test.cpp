// SPDX-License-Identifier: GPL-3.0-or-later
// A proof of the bound of the moments kernel, `proved_rounding`: its own templates run on bounds instead of
// numbers, for all tensors and all quaternions that there are. `close_pair` is not run: the kernel takes what
// it finds only where that agrees with what is proved here.
#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "numeric/lane/moments_lanes.h"

namespace rigor::baseline {

constexpr double u = 0x1p-53;
constexpr double v = 0x1p-106;

/// A number of at most this size that is off by at most this error. Of a pair, high is taken as it is, and
/// all error is that of low.
struct Tracked {
  double size = 0;
  double error = 0;
};

inline Tracked operator+(Tracked a, Tracked b) {
  const double size = a.size + b.size;
  return {size * (1 + u), a.error + b.error + u * size};
}
inline Tracked operator-(Tracked a) { return a; }
inline Tracked operator-(Tracked a, Tracked b) { return a + b; }
inline Tracked operator-(Tracked a, double) { return a; }  // only of 1, from what is near
inline Tracked operator*(Tracked a, Tracked b) {
  const double size = a.size * b.size;
  return {size * (1 + u), a.size * b.error + b.size * a.error + a.error * b.error + u * size};
}
inline Tracked operator*(double power, Tracked a) { return {power * a.size, power * a.error}; }  // of two

inline DoubleDouble<Tracked> exact_sum(Tracked a, Tracked b) {
  const double size = a.size + b.size;
  return {{size * (1 + u), 0}, {u * size, a.error + b.error}};
}
inline DoubleDouble<Tracked> exact_difference(Tracked a, Tracked b) { return exact_sum(a, b); }
inline DoubleDouble<Tracked> exact_product(Tracked a, Tracked b) {
  const double size = a.size * b.size;
  return {{size * (1 + u), 0}, {u * size, a.size * b.error + b.size * a.error + a.error * b.error}};
}
/// The product of the low parts, which is left out, is an error, too.
inline DoubleDouble<Tracked> raw_product(DoubleDouble<Tracked> a, DoubleDouble<Tracked> b) {
  DoubleDouble<Tracked> p = exact_product(a.high, b.high);
  p.low = p.low + (a.high * b.low + a.low * b.high);
  p.low.error += (a.low.size + a.low.error) * (b.low.size + b.low.error);
  return p;
}

namespace {

double error_of(DoubleDouble<Tracked> x) { return x.high.error + x.low.error; }

/// A tensor as the kernel reduces it: entries below 2, their low parts half a unit in the last place; that of
/// the diagonal is off by the sum of a high part and two low ones.
SymmetricTensor<Tracked> any_tensor() {
  SymmetricTensor<Tracked> b;
  for (int i = 0; i < 3; ++i) {
    b.diagonal[i] = {{2, 0}, {4 * u, 8 * v}};
    b.off[i] = {{2, 0}, {2 * u, 0}};
  }
  return b;
}

struct EntryErrors {
  double diagonal = 0;  // of S
  double rotation = 0;  // of M
};

/// Over all quaternions of length 1, by the cells of a grid that cover them; only sizes count, not signs.
EntryErrors greatest_errors() {
  constexpr int cells = 24;
  constexpr double slack = 1e-12;
  const SymmetricTensor<Tracked> b = any_tensor();
  EntryErrors greatest;
  int covered = 0;
  for (int n = 0; n < cells * cells * cells * cells; ++n) {
    const std::array<int, 4> at{n % cells, n / cells % cells, n / cells / cells % cells,
                                n / cells / cells / cells};
    double near = 0;
    double far = 0;
    for (const int k : at) {
      near += k * k / double{cells * cells};
      far += (k + 1) * (k + 1) / double{cells * cells};
    }
    if (near > 1 + slack || far < 1 - slack) continue;
    ++covered;
    const auto upper = [&](std::size_t i) { return Tracked{(at[i] + 1) / double{cells}, 0}; };
    const Rotation<Tracked> m = rotation_of(Quaternion<Tracked>{upper(0), upper(1), upper(2), upper(3)});
    const NearlyDiagonalTensor<Tracked> s = transformed<true>(b, m);
    for (const auto& x : s.diagonal) greatest.diagonal = std::max(greatest.diagonal, error_of(x));
    for (const auto& column : m.column)
      for (const auto& x : column) greatest.rotation = std::max(greatest.rotation, error_of(x));
  }
  CHECK(covered > 10'000);
  return greatest;
}

TEST_CASE("the bound of the moments kernel is proved for all tensors", "[moments]") {
  const EntryErrors greatest = greatest_errors();
  // Off the diagonal S₀₁ is like S₁₁. The others are m_i·(b m₂ − λ m₂): what rounds there without being small
  // itself is the low part of λ m₂, of at most 4 · 18 u, a sum with that of b m₂, below 30 u, and the
  // difference of the high parts, which leaves no more; three times each, for the columns' components. And
  // columns are orthogonal up to the error of M: m_i·λ m₂ = 18 · 2 √3 times that.
  const double separate = greatest.diagonal + 3 * (72 + 102 + 102) * v + 18 * 3.5 * greatest.rotation;
  const double matrix = greatest.diagonal + 2 * separate;  // ‖ΔS‖, by rows; eigenvalues move no more (Weyl)
  // |S_ij| ≤ 18 as tracked, |b| ≤ 6 as it is. The pair's half gap is at most its coupling above |δ|/2, and
  // that is right to 8 u of `nearly_diagonal_pair`; low parts are below 300 u.
  const double pair = 8 * u * nearly_diagonal_pair + u * (nearly_diagonal_pair + 300 * u);
  // Decoupled to second order: t² |p| and t⁴, and roundings of t² |S|, for t < 2^-38.
  const double decoupling = nearly_diagonal * nearly_diagonal * 18 * (8 * u + nearly_diagonal_pair) +
                            std::pow(nearly_diagonal, 4) * 36;
  // 1/|q|⁴ = 1 − e + e², where e is twice what lacks 24 v, and then five roundings of at most u e.
  const double scaling = 6 * (2 * 24 * v + 5 * u * most_excess + std::pow(most_excess, 3)) + u * 300 * u;
  // A pair that is taken up again agrees with all that. The differences of high and of low parts, of which it
  // is told, are rounded; they are below that of the pair's eigenvalues and a low part.
  const double again = agreement * v + 2 * u * (nearly_diagonal_pair + 320 * u);
  const double total = matrix + pair + decoupling + scaling + again;
  INFO("in v: S " << greatest.diagonal / v << ", M " << greatest.rotation / v << ", all " << total / v
                  << " of " << proved_rounding);
  CHECK(total <= proved_rounding * v);
  // It is no better than it must be: three times what rounds in every tensor.
  CHECK(matrix > 300 * v);
}

}  // namespace
}  // namespace rigor::baseline
