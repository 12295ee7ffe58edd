// SPDX-License-Identifier: GPL-3.0-or-later
#include "jet.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fuzz {
namespace {

constexpr double too_near = 1e-3;  // divisors and roots below it would amplify rounding

/// f(u₀ + h) = Σ f⁽ᵏ⁾(u₀)/k! hᵏ, where h has no constant part; `series` has the coefficients of hᵏ.
Jet composed(const Jet& inner, const std::vector<double>& series) {
  Jet h = inner;
  h.coefficients[0] = 0.0;
  Jet sum(*inner.space, series.back());
  for (std::size_t k = series.size() - 1; k-- > 0;) sum = sum * h + Jet(*inner.space, series[k]);
  return sum;
}

/// The derivatives of sin, cos, exp, sinh, cosh come again after four.
std::vector<double> periodic(const std::array<double, 4>& derivatives, int degree) {
  std::vector<double> series;
  double factorial = 1.0;
  for (int k = 0; k <= degree; ++k) {
    if (k > 0) factorial *= k;
    series.push_back(derivatives[static_cast<std::size_t>(k % 4)] / factorial);
  }
  return series;
}

/// (u₀ + h)^p as a series in h.
std::vector<double> binomial(double at, double exponent, int degree) {
  std::vector<double> series{std::pow(at, exponent)};
  for (int k = 1; k <= degree; ++k) series.push_back(series.back() * (exponent - k + 1) / (k * at));
  return series;
}

}  // namespace

JetSpace::JetSpace(std::array<bool, variable_count> varies, int most) : degree(most) {
  std::vector<Exponents> found{Exponents{}};
  for (std::size_t v = 0; v < varies.size(); ++v) {
    if (!varies[v]) continue;
    for (std::size_t k = 0, end = found.size(); k < end; ++k) {
      Exponents next = found[k];
      const int room = most - std::accumulate(next.begin(), next.end(), 0);
      for (int n = 1; n <= room; ++n) {
        next[v] = n;
        found.push_back(next);
      }
    }
  }
  monomials = std::move(found);
  for (std::size_t a = 0; a < monomials.size(); ++a) {
    for (std::size_t b = 0; b < monomials.size(); ++b) {
      Exponents sum = monomials[a];
      for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += monomials[b][v];
      if (const std::size_t result = find(sum); result < monomials.size()) products.push_back({a, b, result});
    }
  }
}

std::size_t JetSpace::find(const Exponents& exponents) const {
  return static_cast<std::size_t>(std::find(monomials.begin(), monomials.end(), exponents) -
                                  monomials.begin());
}

Jet operator+(Jet a, const Jet& b) {
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) a.coefficients[k] += b.coefficients[k];
  return a;
}

Jet operator-(Jet a, const Jet& b) {
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) a.coefficients[k] -= b.coefficients[k];
  return a;
}

Jet operator*(const Jet& a, const Jet& b) {
  Jet result(*a.space);
  for (const JetSpace::Product& product : a.space->products)
    result.coefficients[product.result] += a.coefficients[product.left] * b.coefficients[product.right];
  return result;
}

Jet operator/(const Jet& a, const Jet& b) {
  if (std::abs(b.value()) < too_near) throw NoValue{};
  if (b.coefficients.size() == 1) return Jet(*a.space, a.value() / b.value());
  return a * composed(b, binomial(b.value(), -1.0, b.space->degree));
}

Jet scaled(Jet a, double factor) {
  for (double& coefficient : a.coefficients) coefficient *= factor;
  return a;
}

Jet derivative(const Jet& a, int variable) {
  const auto v = static_cast<std::size_t>(variable);
  Jet result(*a.space);
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) {
    Exponents lowered = a.space->monomials[k];
    if (lowered[v] == 0) continue;
    const double factor = lowered[v]--;
    result.coefficients[a.space->find(lowered)] += factor * a.coefficients[k];
  }
  return result;
}

Jet power(const Jet& a, int exponent) {
  Jet result(*a.space, 1.0);
  for (int k = 0; k < std::abs(exponent); ++k) result = result * a;
  return exponent < 0 ? Jet(*a.space, 1.0) / result : result;
}

Jet root(const Jet& a) {
  if (a.value() < 0.0) throw NoValue{};
  if (a.coefficients.size() == 1) return Jet(*a.space, std::sqrt(a.value()));
  if (a.value() < too_near) throw NoValue{};
  return composed(a, binomial(a.value(), 0.5, a.space->degree));
}

Jet absolute(const Jet& a) {
  if (a.value() == 0.0 && a.coefficients.size() > 1) throw NoValue{};
  return a.value() < 0.0 ? scaled(a, -1.0) : a;
}

Jet apply(Function function, const Jet& a) {
  const double u = a.value();
  const int degree = a.space->degree;
  if (std::abs(u) > 20.0) throw NoValue{};
  switch (function) {
    case Function::sin:
      return composed(a, periodic({std::sin(u), std::cos(u), -std::sin(u), -std::cos(u)}, degree));
    case Function::cos:
      return composed(a, periodic({std::cos(u), -std::sin(u), -std::cos(u), std::sin(u)}, degree));
    case Function::tan:
      return apply(Function::sin, a) / apply(Function::cos, a);
    case Function::exp:
      return composed(a, periodic({std::exp(u), std::exp(u), std::exp(u), std::exp(u)}, degree));
    case Function::sinh:
      return composed(a, periodic({std::sinh(u), std::cosh(u), std::sinh(u), std::cosh(u)}, degree));
    case Function::cosh:
      return composed(a, periodic({std::cosh(u), std::sinh(u), std::cosh(u), std::sinh(u)}, degree));
    case Function::tanh:
      return apply(Function::sinh, a) / apply(Function::cosh, a);
    case Function::ln: {
      if (u < too_near) throw NoValue{};
      std::vector<double> series{std::log(u)};
      double factor = 1.0;
      for (int k = 1; k <= degree; ++k) {
        factor /= -u;
        series.push_back(-factor / k);
      }
      return composed(a, series);
    }
  }
  throw NoValue{};
}

}  // namespace fuzz
