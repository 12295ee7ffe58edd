// SPDX-License-Identifier: GPL-3.0-or-later
// Truncated Taylor series in t, x, y, z and one small number: what every quantity of a sample is. The
// coefficient of 1 is the value, the others are the derivatives, so that differentiating is a shift. Plain
// doubles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace fuzz {

inline constexpr int variable_count = 5;  // t, x, y, z, small
inline constexpr int time_variable = 0;
inline constexpr int small_variable = 4;
using Exponents = std::array<int, variable_count>;

/// All monomials in some of the variables up to a total degree, and how they multiply.
struct JetSpace {
  JetSpace(std::array<bool, variable_count> varies, int most);

  struct Product {
    std::size_t left, right, result;
  };
  int degree;
  std::vector<Exponents> monomials;  // the first one is 1
  std::vector<Product> products;

  [[nodiscard]] std::size_t find(const Exponents& exponents) const;  // `monomials.size()`: not in it
};

/// Thrown where a quantity has no value: 1/0, the root of a negative number.
struct NoValue {};

struct Jet {
  explicit Jet(const JetSpace& its_space, double value = 0.0)
      : space(&its_space), coefficients(its_space.monomials.size()) {
    coefficients[0] = value;
  }
  const JetSpace* space;
  std::vector<double> coefficients;

  [[nodiscard]] double value() const { return coefficients[0]; }
};

[[nodiscard]] Jet operator+(Jet a, const Jet& b);
[[nodiscard]] Jet operator-(Jet a, const Jet& b);
[[nodiscard]] Jet operator*(const Jet& a, const Jet& b);
[[nodiscard]] Jet operator/(const Jet& a, const Jet& b);
[[nodiscard]] Jet scaled(Jet a, double factor);
[[nodiscard]] Jet derivative(const Jet& a, int variable);
[[nodiscard]] Jet power(const Jet& a, int exponent);
[[nodiscard]] Jet root(const Jet& a);
[[nodiscard]] Jet absolute(const Jet& a);

enum class Function { sin, cos, tan, exp, sinh, cosh, tanh, ln };
[[nodiscard]] Jet apply(Function function, const Jet& a);

}  // namespace fuzz
