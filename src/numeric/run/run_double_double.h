// SPDX-License-Identifier: GPL-3.0-or-later
// Double-double numbers of the QD library as numbers of programs. What overflows ends in infinity or NaN. QD
// prints a message where a root or a logarithm has no value: it is not asked there.
#pragma once

#include <qd/dd_real.h>

#include <limits>

#include "numeric/run/run_numbers.h"

namespace rigor {

template <>
struct NumberTraits<dd_real> {
  static constexpr bool has_lanes = true;
  static dd_real none() { return {std::numeric_limits<double>::quiet_NaN(), 0.0}; }
  static dd_real root(const dd_real& x) {
    if (!(x.x[0] > 0.0) || std::isinf(x.x[0])) return std::sqrt(x.x[0]);
    return sqrt(x);
  }
  static dd_real absolute(const dd_real& x) { return abs(x); }
  static dd_real sine(const dd_real& x) { return is_angle(x) ? sin(x) : none(); }
  static dd_real cosine(const dd_real& x) { return is_angle(x) ? cos(x) : none(); }
  static dd_real exponential(const dd_real& x) { return std::isnan(x.x[0]) ? none() : exp(x); }
  static dd_real tangent(const dd_real& x) { return is_angle(x) ? tan(x) : none(); }
  static dd_real hyperbolic_sine(const dd_real& x) { return std::isnan(x.x[0]) ? none() : sinh(x); }
  static dd_real hyperbolic_cosine(const dd_real& x) { return std::isnan(x.x[0]) ? none() : cosh(x); }
  static dd_real hyperbolic_tangent(const dd_real& x) {
    if (std::isnan(x.x[0])) return none();
    return std::abs(x.x[0]) > flat ? dd_real(std::copysign(1.0, x.x[0])) : tanh(x);
  }
  static dd_real read(const std::string& digits) { return dd_real(digits.c_str()); }

 private:
  /// Beyond this, tanh is 1 to 106 bits.
  static constexpr double flat = 40;
  /// Beyond this, nothing is left of the angle modulo 2π.
  static bool is_angle(const dd_real& x) { return std::abs(x.x[0]) < 1e30; }
};

}  // namespace rigor
