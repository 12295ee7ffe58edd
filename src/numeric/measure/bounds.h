// SPDX-License-Identifier: GPL-3.0-or-later
// A program in double with a running error bound: every value carries a bound of its distance from what it
// would be without any rounding, for inputs that are exact or known to a relative uncertainty. Infinite where
// no bound is known: a divisor, or what is under a root, that may be 0; what overflows. With u = 2^-53, η
// = 2^-1074 and operands x ± d, y ± e (Higham, Accuracy and Stability of Numerical Algorithms, 3.3):
//   x + y:  d + e + u|x + y|                 x y:  |x|e + |y|d + d e + u|x y| + η
//   x / y:  (d + |x/y|e) / (|y| − e) + u|x/y| + η          √x:  d / (√x + √(x − d)) + u√x
//   sin, cos:  d + 4u                        exp:  eˣ(e^d − 1) + 4u eˣ, e^(x + d) below the normal range
// all rounded upwards by a factor 1 + 8u. The square root of a number that is 0 within its bound is bounded
// by √(x + d): it is taken for granted that it has a real value. The library's sin, cos and exp are taken to
// be right to 2 units in the last place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"

namespace rigor {

struct BoundedResults {
  std::vector<double> values;  // output · samples + sample
  std::vector<double> bounds;  // of |value − exact|
};

/// `uncertainty`: every input is known only to within this times its size, on top of the samples' own errors;
/// 0: the doubles are exact.
[[nodiscard]] BoundedResults evaluate_with_bounds(const Program& program, const Samples& samples,
                                                  double uncertainty = 0.0,
                                                  std::span<const std::uint32_t> at = {});

/// Bounds of |value − exact|, for values of any arithmetic and order of summation, and for any exact inputs
/// within the errors of the samples (low parts included). From `evaluate_with_bounds`, and, where inputs have
/// low parts and nothing is summed over particles, from 100 digits with a bound (`run_bounded_decimal.h`):
/// the lesser one. Infinite where neither knows any.
[[nodiscard]] std::vector<double> error_bounds(const Program& program, const Samples& samples,
                                               std::span<const double> values);

/// Does the program read an input with more digits than two doubles hold?
[[nodiscard]] bool have_digits(const Program& program, const Samples& samples);

/// `values` with `error_bounds`; of inputs with more digits, the results in 100 of them, rounded. Where that
/// leaves open on which side of 0 a result is, the result in rational numbers, if the inputs are rational, or
/// else in 400 digits. Sums over particles are left as they are.
[[nodiscard]] BoundedResults enclosures(const Program& program, const Samples& samples,
                                        std::vector<double> values);

}  // namespace rigor
