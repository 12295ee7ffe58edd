// SPDX-License-Identifier: GPL-3.0-or-later
// A sum of products of doubles without any rounding, as an expansion: J. R. Shewchuk, Discrete Comput. Geom.
// 18 (1997) 305, GROW-EXPANSION. For differences whose sign and leading digits must survive any cancellation.
#pragma once

#include "numeric/lane/double_double.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// Parts do not overlap and grow. Room for two products and one term more.
struct ExactTerms {
  double parts[33] = {};
  int count = 0;

  RIGOR_INLINE void add(double x) {
    for (int i = 0; i < count; ++i) {
      const DoubleDouble<double> s = exact_sum(x, parts[i]);
      x = s.high;
      parts[i] = s.low;
    }
    parts[count++] = x;
  }

  /// ± a b c, exact unless a product underflows. 16 parts.
  RIGOR_INLINE void add_product(double a, DoubleDouble<double> b, DoubleDouble<double> c, double sign) {
    const DoubleDouble<double> ab[2] = {exact_product(a, b.high), exact_product(a, b.low)};
    const double left[4] = {ab[0].high, ab[0].low, ab[1].high, ab[1].low};
    for (int i = 0; i < 4; ++i) {
      const double right[2] = {c.high, c.low};
      for (int k = 0; k < 2; ++k) {
        const DoubleDouble<double> p = exact_product(left[i], sign * right[k]);
        add(p.high);
        add(p.low);
      }
    }
  }

  /// Relative error 2^-104; exactly 0 only for 0.
  [[nodiscard]] RIGOR_INLINE DoubleDouble<double> value() const {
    DoubleDouble<double> sum{};
    for (int i = 0; i < count; ++i) sum = sum + parts[i];
    return sum;
  }
};

}  // namespace rigor::RIGOR_INSTRUCTION_SET
