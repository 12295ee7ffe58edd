// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/kernel.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <optional>

#include "algebra/ring/fraction.h"

namespace rigor {
namespace {

using GiNaC::ex;
using Triple = std::array<ex, 3>;

constexpr std::size_t most_equations = 6;
constexpr std::size_t longest_coefficient = 12;  // of a coefficient

/// The coefficients, if the equation is linear and homogeneous in the components.
[[nodiscard]] std::optional<Triple> coefficients(const ex& equation, const Triple& vector) {
  Triple row;
  ex rest = equation;
  for (std::size_t i = 0; i < 3; ++i) {
    if (equation.degree(vector[i]) > 1) return std::nullopt;
    row[i] = equation.coeff(vector[i], 1);
    if (term_count(row[i]) > longest_coefficient) return std::nullopt;
    const bool mixed = std::ranges::any_of(vector, [&](const ex& x) { return row[i].has(x); });
    if (mixed) return std::nullopt;
    rest = rest.coeff(vector[i], 0);
  }
  if (!rest.is_zero()) return std::nullopt;
  return row;
}

[[nodiscard]] ex determinant(const Triple& a, const Triple& b, const Triple& c) {
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0]))
      .expand();
}

}  // namespace

std::vector<KernelDeterminant> kernel_determinants(std::span<const ex> equations, const Triple& vector) {
  std::vector<Triple> rows;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    if (equations[i].is_zero() || rows.size() >= most_equations) continue;
    const auto row = coefficients(equations[i], vector);
    if (!row) continue;
    rows.push_back(*row);
    positions.push_back(i);
  }
  std::vector<KernelDeterminant> found;
  for (std::size_t a = 0; a < rows.size(); ++a) {
    for (std::size_t b = a + 1; b < rows.size(); ++b) {
      for (std::size_t c = b + 1; c < rows.size(); ++c) {
        ex value = determinant(rows[a], rows[b], rows[c]);
        if (!value.is_zero()) found.push_back({{positions[a], positions[b], positions[c]}, std::move(value)});
      }
    }
  }
  return found;
}

}  // namespace rigor
