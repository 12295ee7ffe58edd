// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numeric/kernels/moment_families.h"

namespace rigor {
namespace {

using Integer = boost::multiprecision::cpp_int;

template <class Number>
struct Diagonalised {
  std::array<std::array<Number, 3>, 3> tensor;
  std::array<std::array<Number, 3>, 3> axes;  // columns
  Number norm;                                // Frobenius

  [[nodiscard]] Number gap(std::size_t j, std::size_t k) const { return tensor[k][k] - tensor[j][j]; }
};

/// One of Jacobi's rotations, which makes the entry (p, q) zero. Source: G. H. Golub, C. F. Van Loan, Matrix
/// Computations, 4th edition, section 8.5.2.
template <class Number>
void rotate(Diagonalised<Number>& d, std::size_t p, std::size_t q) {
  auto& a = d.tensor;
  if (a[p][q] == 0) return;
  const Number tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const Number t = (tau < 0 ? -1 : 1) / (abs(tau) + sqrt(1 + tau * tau));
  const Number c = 1 / sqrt(1 + t * t);
  const Number s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const Number x = a[k][p];
    a[k][p] = c * x - s * a[k][q];
    a[k][q] = s * x + c * a[k][q];
    const Number v = d.axes[k][p];
    d.axes[k][p] = c * v - s * d.axes[k][q];
    d.axes[k][q] = s * v + c * d.axes[k][q];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Number x = a[p][k];
    a[p][k] = c * x - s * a[q][k];
    a[q][k] = s * x + c * a[q][k];
  }
  a[p][q] = a[q][p] = 0;
}

/// Converges quadratically: 12 sweeps are more than 400 digits need.
template <class Number, class Tensor>
Diagonalised<Number> diagonalised(const Tensor& tensor) {
  Diagonalised<Number> d{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      d.tensor[i][j] = tensor[std::max(i, j)][std::min(i, j)];
      d.axes[i][j] = i == j ? 1 : 0;
      d.norm += d.tensor[i][j] * d.tensor[i][j];
    }
  }
  d.norm = sqrt(d.norm);
  const Number negligible = d.norm * std::numeric_limits<Number>::epsilon() * 1e-3;
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = std::min(i, (i + 1) % 3);
      const std::size_t q = std::max(i, (i + 1) % 3);
      if (abs(d.tensor[p][q]) > negligible) rotate(d, p, q);
    }
  }
  return d;
}

/// What is exactly so of the eigenvalues.
struct ExactFacts {
  std::size_t zeros = 0;
  std::size_t equal = 1;  // how many are one number
};

/// From x³ − a x² + b x − c with integers, which a power of two makes of the doubles.
ExactFacts exact_facts(const InertiaTensor& tensor) {
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (tensor[i][j] != 0) least = std::min(least, std::ilogb(tensor[i][j]) - 52);
  std::array<std::array<Integer, 3>, 3> t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      int exponent = 0;
      const double fraction = std::frexp(tensor[i][j], &exponent);
      if (fraction != 0)
        t[i][j] = t[j][i] = Integer(static_cast<std::int64_t>(std::ldexp(fraction, 53))) *
                            (Integer(1) << (exponent - 53 - least));
    }
  }
  const Integer a = t[0][0] + t[1][1] + t[2][2];
  Integer b = 0;
  Integer c = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    b += t[i][i] * t[j][j] - t[i][j] * t[j][i];
    c += t[0][i] * (t[1][j] * t[2][k] - t[1][k] * t[2][j]);
  }
  ExactFacts facts;
  facts.zeros = c != 0 ? 0 : b != 0 ? 1 : a != 0 ? 2 : 3;
  const Integer discriminant =
      a * a * b * b - 4 * b * b * b - 4 * a * a * a * c + 18 * a * b * c - 27 * c * c;
  if (discriminant == 0) facts.equal = a * a == 3 * b ? 3 : 2;
  return facts;
}

/// Order of size.
template <class Number>
std::array<std::size_t, 3> ascending(const Diagonalised<Number>& d) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return d.tensor[a][a] < d.tensor[b][b]; });
  return order;
}

/// The eigenvalues, with those that are exactly 0 or equal made so.
template <class Number>
std::array<Number, 3> with_facts(const Diagonalised<Number>& d, const ExactFacts& facts) {
  std::array<Number, 3> moments;
  const auto order = ascending(d);
  for (std::size_t k = 0; k < 3; ++k) moments[k] = d.tensor[order[k]][order[k]];
  std::array<std::size_t, 3> by_size{0, 1, 2};
  std::sort(by_size.begin(), by_size.end(),
            [&](std::size_t a, std::size_t b) { return abs(moments[a]) < abs(moments[b]); });
  for (std::size_t k = 0; k < facts.zeros; ++k) moments[by_size[k]] = 0;
  if (facts.equal == 3) moments[1] = moments[2] = moments[0];
  if (facts.equal == 2) {
    const std::size_t j = moments[1] - moments[0] < moments[2] - moments[1] ? 0 : 1;
    const Number mean =
        moments[j] == 0 || moments[j + 1] == 0 ? Number(0) : (moments[j] + moments[j + 1]) / 2;
    moments[j] = moments[j + 1] = mean;
  }
  return moments;
}

/// Is every moment and gap above `bound`, but for those that are exactly 0?
template <class Number>
bool has_digits(const std::array<Number, 3>& moments, const ExactFacts& facts, const Number& bound) {
  std::size_t small = 0;
  for (const Number& moment : moments) small += abs(moment) <= bound ? 1 : 0;
  std::size_t close = 0;
  for (std::size_t k = 0; k < 2; ++k) close += moments[k + 1] - moments[k] <= bound ? 1 : 0;
  return small == facts.zeros && close == facts.equal - 1;
}

template <class Number>
PrincipalReference reference_of(const Diagonalised<Number>& d, const std::array<Number, 3>& moments) {
  PrincipalReference reference;
  const auto order = ascending(d);
  constexpr std::array<std::pair<std::size_t, std::size_t>, 3> pairs{{{0, 1}, {1, 2}, {0, 2}}};
  for (std::size_t k = 0; k < 3; ++k) {
    reference.moments[k] = static_cast<Digits50>(moments[k]);
    reference.gaps[k] = static_cast<Digits50>(Number(moments[pairs[k].second] - moments[pairs[k].first]));
    for (std::size_t i = 0; i < 3; ++i) reference.axes[k][i] = static_cast<Digits50>(d.axes[i][order[k]]);
  }
  return reference;
}

}  // namespace

PrincipalReference principal_reference(const InertiaTensor& tensor) {
  const auto d = diagonalised<Decimal<100>>(tensor);
  const Decimal<100> bound = d.norm * Decimal<100>("1e-45");
  const auto moments = with_facts(d, {});
  if (has_digits(moments, {}, bound)) return reference_of(d, moments);
  const ExactFacts facts = exact_facts(tensor);
  const auto exact = with_facts(d, facts);
  if (has_digits(exact, facts, bound)) return reference_of(d, exact);
  const auto longer = diagonalised<Decimal<400>>(tensor);
  const auto more = with_facts(longer, facts);
  if (!has_digits(more, facts, Decimal<400>(longer.norm * Decimal<400>("1e-345"))))
    throw std::domain_error("a moment or gap below 1e-345 of the norm");
  return reference_of(longer, more);
}

PrincipalReference principal_reference_of_digits(const std::array<std::array<Decimal<100>, 3>, 3>& tensor) {
  const auto d = diagonalised<Decimal<100>>(tensor);
  return reference_of(d, with_facts(d, {}));
}

double relative_error(double computed, const Digits50& exact, const Digits50& norm, double low) {
  if (!std::isfinite(computed) || !std::isfinite(low)) return std::numeric_limits<double>::infinity();
  const Digits50 value = Digits50(computed) + low;
  if (exact == 0) return value == 0 ? 0 : static_cast<double>(Digits50(abs(value) / norm));
  if (value * exact < 0) return std::numeric_limits<double>::infinity();
  const Digits50 wrong = abs(value - exact) - 0x1p-1074;
  return wrong <= 0 ? 0 : static_cast<double>(Digits50(wrong / abs(exact)));
}

}  // namespace rigor
