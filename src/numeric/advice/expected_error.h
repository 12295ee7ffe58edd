// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding makes of a form at a point, to first order: each operation errs by about u of its result v,
// which moves the form by (∂f/∂v) v u; the root of the sum of squares is what independent roundings amount
// to. No luck counts: an error of a single evaluation can be 0 by chance, and the least of several would then
// say nothing. Source: S. Linnainmaa, "Taylor expansion of the accumulated rounding error", BIT 16 (1976)
// 146; the derivatives by reverse differentiation in long double, whose range shows where double overflows or
// loses bits near 0. Cost: about four evaluations for each component of the result.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "numeric/advice/run_values.h"

namespace rigor {

/// Double keeps all of its bits from here on.
inline constexpr long double least_normal = std::numeric_limits<double>::min();

struct ExpectedError {
  /// Relative to the largest component, from u to 1; 1: no digit is right. Below the normal range of double,
  /// relative to its least number: nothing is lost there that double could hold.
  double relative = 1;
  long double size = 0;    // of the largest component
  bool has_value = false;  // in long double
  bool outside = false;    // the form as it is written has no real value: a root of what is clearly negative,
                           // or a quotient by what is 0 without any rounding
};

/// For points of one form, one after the other.
class ErrorTape {
 public:
  explicit ErrorTape(const Code& code);
  [[nodiscard]] ExpectedError at(std::span<const double> inputs);
  /// Of the last point: the relative error that double makes there, where another form knows the value;
  /// infinite for what is not finite.
  [[nodiscard]] double seen(const ErrorTape& value) const;

 private:
  [[nodiscard]] long double moved(ValueId output);
  void pass_on(ValueId id);
  [[nodiscard]] long double own_rounding(ValueId id) const;
  [[nodiscard]] bool is_outside() const;
  [[nodiscard]] std::vector<bool> unrounded() const;
  [[nodiscard]] bool keeps_all(const Value& value, long double result) const;

  const Code& code_;
  ValuesAtPoint<double> rounded_;
  ValuesAtPoint<long double> wide_;
  std::vector<bool> exact_;  // operations that round nothing
  std::vector<long double> adjoint_;
};

}  // namespace rigor
