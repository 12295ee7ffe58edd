// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of every kind of number that programs run on: roots of what is negative are NaN, without a
// message or an exception; constants are read from their decimal digits.
#pragma once

#include <cmath>
#include <string>

#include "numeric/program/code.h"

namespace rigor {

template <class T>
struct NumberTraits {
  static T root(const T& x) { return std::sqrt(x); }
  static T absolute(const T& x) { return std::abs(x); }
  static T sine(const T& x) { return std::sin(x); }
  static T cosine(const T& x) { return std::cos(x); }
  static T exponential(const T& x) { return std::exp(x); }
  static T tangent(const T& x) { return std::tan(x); }
  static T hyperbolic_sine(const T& x) { return std::sinh(x); }
  static T hyperbolic_cosine(const T& x) { return std::cosh(x); }
  static T hyperbolic_tangent(const T& x) { return std::tanh(x); }
  static T read(const std::string& digits);
  static constexpr bool has_lanes = true;
};

template <>
inline float NumberTraits<float>::read(const std::string& digits) {
  return std::strtof(digits.c_str(), nullptr);
}
template <>
inline double NumberTraits<double>::read(const std::string& digits) {
  return std::strtod(digits.c_str(), nullptr);
}
template <>
inline long double NumberTraits<long double>::read(const std::string& digits) {
  return std::strtold(digits.c_str(), nullptr);
}

template <class T>
[[nodiscard]] T number_of(const Constant& constant) {
  return constant.digits.empty() ? T(constant.value) : NumberTraits<T>::read(constant.digits);
}

}  // namespace rigor
