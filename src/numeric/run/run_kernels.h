// SPDX-License-Identifier: GPL-3.0-or-later
// One function for each step and each choice of wide operands, over Eigen arrays of `lane_count` numbers; on
// doubles those of `run_steps.h`, where there is one. A
// fused step rounds after each of its operations, as separate steps would: the floor is compiled without
// contraction into fused multiply-add instructions. Results may overwrite operands: all is lane by lane.
#pragma once

#include <Eigen/Core>
#include <type_traits>

#include "base/check.h"
#include "numeric/run/run_numbers.h"
#include "numeric/run/run_steps.h"

namespace rigor {

namespace kernels {

template <class T>
using LaneArray = Eigen::Array<T, lane_count, 1>;

template <class T, bool wide>
[[nodiscard]] decltype(auto) operand(T* at) {
  if constexpr (wide) {
    return Eigen::Map<const LaneArray<T>>(at);
  } else {
    return static_cast<const T&>(*at);
  }
}

template <Kernel kernel, class T>
[[nodiscard]] T function_of(const T& x) {
  if constexpr (kernel == Kernel::root) return NumberTraits<T>::root(x);
  if constexpr (kernel == Kernel::absolute) return NumberTraits<T>::absolute(x);
  if constexpr (kernel == Kernel::sin) return NumberTraits<T>::sine(x);
  if constexpr (kernel == Kernel::cos) return NumberTraits<T>::cosine(x);
  if constexpr (kernel == Kernel::exp) return NumberTraits<T>::exponential(x);
  if constexpr (kernel == Kernel::tan) return NumberTraits<T>::tangent(x);
  if constexpr (kernel == Kernel::sinh) return NumberTraits<T>::hyperbolic_sine(x);
  if constexpr (kernel == Kernel::cosh) return NumberTraits<T>::hyperbolic_cosine(x);
  if constexpr (kernel == Kernel::tanh) return NumberTraits<T>::hyperbolic_tangent(x);
}

/// Each operand is computed once.
template <class T, class Value>
[[nodiscard]] auto square_of(const Value& value) {
  if constexpr (std::is_same_v<Value, T>) {
    return T(value * value);
  } else {
    return value.square();
  }
}

template <class T, bool wide, class Value>
void store(T* out, const Value& value) {
  if constexpr (!wide) {
    *out = value;
  } else if constexpr (std::is_same_v<Value, T>) {
    Eigen::Map<LaneArray<T>, Eigen::Aligned16> lanes(out);
    lanes.setConstant(value);
  } else {
    Eigen::Map<LaneArray<T>, Eigen::Aligned16> lanes(out);
    lanes = value;
  }
}

/// Only so many lanes are added to: the others hold no particle.
template <class T, bool wide, class Value>
void accumulate(T* out, const Value& value, bool over_lanes, int lanes) {
  if constexpr (!wide) {
    *out = *out + value;
  } else {
    Eigen::Map<LaneArray<T>, Eigen::Aligned16> total(out);
    if (!over_lanes || lanes == lane_count) {
      total += value;
    } else if constexpr (std::is_same_v<Value, T>) {
      total.head(lanes) += value;
    } else {
      total.head(lanes) += value.head(lanes);
    }
  }
}

/// The sum of all lanes: the upper half is added to the lower one until one number is left.
template <class T>
[[nodiscard]] T folded(T* lanes) {
  for (int half = lane_count / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) lanes[i] = lanes[i] + lanes[i + half];
  }
  return lanes[0];
}

template <class T, Kernel kernel, unsigned wide>
void run(T* const* slots, const PlanStep& step, int lanes) {
  constexpr bool to_wide = (wide & wide_result) != 0;
  T* const out = slots[step.out];
#define X(k) operand<T, (wide >> k & 1u) != 0>(slots[step.in[k]])
// The sign of a triple goes to its narrow factor: that is exact.
#define S(k, triple) T((step.minus >> triple & 1u) != 0 ? T(-X(k)) : X(k))
  if constexpr (kernel == Kernel::clear) store<T, to_wide>(out, T(0));
  if constexpr (kernel == Kernel::copy) store<T, to_wide>(out, X(0));
  if constexpr (kernel == Kernel::negate) store<T, to_wide>(out, -X(0));
  if constexpr (kernel == Kernel::add) store<T, to_wide>(out, X(0) + X(1));
  if constexpr (kernel == Kernel::subtract) store<T, to_wide>(out, X(0) - X(1));
  if constexpr (kernel == Kernel::multiply) store<T, to_wide>(out, X(0) * X(1));
  if constexpr (kernel == Kernel::divide) store<T, to_wide>(out, X(0) / X(1));
  if constexpr (kernel == Kernel::multiply_add) store<T, to_wide>(out, X(0) * X(1) + X(2));
  if constexpr (kernel == Kernel::multiply_subtract) store<T, to_wide>(out, X(0) * X(1) - X(2));
  if constexpr (kernel == Kernel::subtract_product) store<T, to_wide>(out, X(2) - X(0) * X(1));
  if constexpr (kernel == Kernel::product_sum) store<T, to_wide>(out, X(0) * X(1) + X(2) * X(3));
  if constexpr (kernel == Kernel::product_difference) store<T, to_wide>(out, X(0) * X(1) - X(2) * X(3));
  if constexpr (kernel == Kernel::product_sum_3)
    store<T, to_wide>(out, (X(0) * X(1) + X(2) * X(3)) + X(4) * X(5));
  if constexpr (kernel == Kernel::square_sum_3)
    store<T, to_wide>(out, (X(0) * X(0) + X(1) * X(1)) + X(2) * X(2));
  if constexpr (kernel == Kernel::cross_square)
    store<T, to_wide>(out,
                      (square_of<T>(X(0) * X(3) - X(1) * X(4)) + square_of<T>(X(1) * X(5) - X(2) * X(3))) +
                          square_of<T>(X(2) * X(4) - X(0) * X(5)));
  if constexpr (kernel == Kernel::product_3) store<T, to_wide>(out, (X(0) * X(1)) * X(2));
  if constexpr (kernel == Kernel::triple_sum_3)
    store<T, to_wide>(out, (X(0) * S(1, 0) * X(2) + X(3) * S(4, 1) * X(5)) + X(6) * S(7, 2) * X(8));
  if constexpr (kernel == Kernel::add_triple_sum_3)
    store<T, to_wide>(out, ((X(0) + X(1) * S(2, 0) * X(3)) + X(4) * S(5, 1) * X(6)) + X(7) * S(8, 2) * X(9));
  if constexpr (kernel == Kernel::accumulate) accumulate<T, to_wide>(out, X(0), step.over_lanes, lanes);
  if constexpr (kernel == Kernel::accumulate_product)
    accumulate<T, to_wide>(out, X(0) * X(1), step.over_lanes, lanes);
  if constexpr (kernel == Kernel::fold) *out = folded(slots[step.in[0]]);
  if constexpr (kernel >= Kernel::absolute && kernel <= Kernel::tanh) {
    if constexpr (!to_wide) {
      *out = function_of<kernel>(X(0));
    } else {
      store<T, true>(out, X(0).unaryExpr([](const T& x) { return function_of<kernel>(x); }));
    }
  }
#undef X
#undef S
}

/// Doubles have their own functions, but for those of the standard library.
template <class T, Kernel kernel>
inline constexpr bool is_here = NumberTraits<T>::has_lanes &&
                                (!std::is_same_v<T, double> ||
                                 (kernel >= Kernel::sin && kernel <= Kernel::tanh));

template <class T, Kernel kernel, unsigned... choices>
[[nodiscard]] StepFunction<T> choose(unsigned wide) {
  StepFunction<T> chosen = nullptr;
  if (wide == 0) return &run<T, kernel, 0>;
  if constexpr (is_here<T, kernel>)
    static_cast<void>(((wide == choices ? (chosen = &run<T, kernel, choices>, true) : false) || ...));
  RIGOR_CHECK(chosen != nullptr, static_cast<int>(kernel), wide);
  return chosen;
}

/// Operands are wide in the order in which `run_fuse.h` puts them.
template <class T>
[[nodiscard]] StepFunction<T> function_for(const PlanStep& step) {
  if constexpr (std::is_same_v<T, double>) {
    if (const StepFunction<double> found = wide_steps()(step)) return found;
  }
// For these choices of what is wide, and for nothing wide.
#define CASE(kernel, ...) \
  case Kernel::kernel:    \
    return choose<T, Kernel::kernel, __VA_ARGS__>(step.wide)
  switch (step.kernel) {
    CASE(clear, 0x8000);
    CASE(copy, 0x8000, 0x8001);
    CASE(negate, 0x8001);
    CASE(absolute, 0x8001);
    CASE(root, 0x8001);
    CASE(sin, 0x8001);
    CASE(cos, 0x8001);
    CASE(exp, 0x8001);
    CASE(tan, 0x8001);
    CASE(sinh, 0x8001);
    CASE(cosh, 0x8001);
    CASE(tanh, 0x8001);
    CASE(add, 0x8001, 0x8003);
    CASE(subtract, 0x8001, 0x8002, 0x8003);
    CASE(multiply, 0x8001, 0x8003);
    CASE(divide, 0x8001, 0x8002, 0x8003);
    CASE(multiply_add, 0x8001, 0x8003, 0x8005, 0x8007);
    CASE(multiply_subtract, 0x8001, 0x8003, 0x8005, 0x8007);
    CASE(subtract_product, 0x8001, 0x8003, 0x8005, 0x8007);
    CASE(product_sum, 0x8005, 0x8007, 0x800d, 0x800f);
    CASE(product_difference, 0x8005, 0x8007, 0x800d, 0x800f);
    CASE(product_sum_3, 0x8015, 0x803f);
    CASE(square_sum_3, 0x8007);
    CASE(cross_square, 0x8007, 0x803f);
    CASE(product_3, 0x8001, 0x8003, 0x8005, 0x8007);
    CASE(triple_sum_3, 0x816d);
    CASE(add_triple_sum_3, 0x82db);
    CASE(accumulate, 0x8000, 0x8001);
    CASE(accumulate_product, 0x8001, 0x8003);
    case Kernel::fold:
      if constexpr (is_here<T, Kernel::fold>) return &run<T, Kernel::fold, 1>;
      break;
    case Kernel::loop:
      break;
  }
#undef CASE
  RIGOR_CHECK(false, static_cast<int>(step.kernel));
  return nullptr;
}

}  // namespace kernels
}  // namespace rigor
