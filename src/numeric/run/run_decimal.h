// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of many decimal digits as numbers of programs: the exponent has 31 bits, so that nothing that
// doubles can lead to overflows. Heavy: for the few sources that compute references.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "numeric/run/run_numbers.h"

namespace rigor {

template <unsigned digits>
using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>,
                                              boost::multiprecision::et_off>;

template <unsigned digits>
struct NumberTraits<Decimal<digits>> {
  using T = Decimal<digits>;
  static constexpr bool has_lanes = false;
  static T none() { return std::numeric_limits<T>::quiet_NaN(); }
  static T root(const T& x) {
    return x < 0 || boost::multiprecision::isnan(x) ? none() : boost::multiprecision::isinf(x) ? x : sqrt(x);
  }
  static T absolute(const T& x) { return abs(x); }
  static T sine(const T& x) { return boost::multiprecision::isfinite(x) ? sin(x) : none(); }
  static T cosine(const T& x) { return boost::multiprecision::isfinite(x) ? cos(x) : none(); }
  static T exponential(const T& x) {
    if (boost::multiprecision::isnan(x)) return none();
    if (x > 5e8) return std::numeric_limits<T>::infinity();
    return x < -5e8 ? T(0) : exp(x);
  }
  static T tangent(const T& x) { return boost::multiprecision::isfinite(x) ? tan(x) : none(); }
  static T hyperbolic_sine(const T& x) { return x < 0 ? T(-grown(-x, false)) : grown(x, false); }
  static T hyperbolic_cosine(const T& x) { return grown(abs(x), true); }
  static T hyperbolic_tangent(const T& x) {
    if (boost::multiprecision::isnan(x)) return none();
    if (abs(x) > 5e8) return x < 0 ? T(-1) : T(1);
    return tanh(x);
  }
  static T read(const std::string& text) { return T(text); }

 private:
  /// sinh or cosh of what is not negative.
  static T grown(const T& x, bool even) {
    if (boost::multiprecision::isnan(x)) return none();
    if (x > 5e8) return std::numeric_limits<T>::infinity();
    return even ? T(cosh(x)) : T(sinh(x));
  }
};

}  // namespace rigor
