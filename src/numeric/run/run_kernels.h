// SPDX-License-Identifier: GPL-3.0-or-later
// One function for each step and each choice of wide operands, lane by lane; on doubles those of
// `run_steps.h`, where there is one. A fused step rounds after each of its operations, as separate steps
// would: the floor is compiled without contraction into fused multiply-add instructions. Results may
// overwrite operands.
#pragma once

#include <type_traits>

#include "base/check.h"
#include "numeric/run/run_numbers.h"
#include "numeric/run/run_steps.h"
#include "numeric/run/step_values.h"

namespace rigor {

namespace kernels {

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

/// The sum of all lanes: the upper half is added to the lower one until one number is left.
template <class T>
[[nodiscard]] T folded(T* lanes) {
  for (int half = lane_count / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) lanes[i] = lanes[i] + lanes[i + half];
  }
  return lanes[0];
}

template <Kernel kernel>
inline constexpr bool is_function = kernel >= Kernel::absolute&& kernel <= Kernel::tanh;

template <Kernel kernel, class T>
[[nodiscard]] T value_of(const T* x) {
  if constexpr (is_function<kernel>)
    return function_of<kernel>(x[0]);
  else
    return baseline::value_of<kernel>(x);
}

/// What is left to do with the value of a step.
template <class T>
[[nodiscard]] T ended(const T& value, const T* out, const T* factor, const PlanStep& step) {
  T result = value;
  if (factor != nullptr) result = step.ending == Ending::divide ? T(value / *factor) : T(value * *factor);
  if (step.negated) result = -result;
  return step.ending == Ending::add ? T(*out + result) : result;
}

template <class T, Kernel kernel, unsigned wide>
void run(T* const* slots, const PlanStep& step, int lanes) {
  T* const out = slots[step.out];
  if constexpr (kernel == Kernel::clear) {
    for (int i = 0; i < (wide == 0 ? 1 : lanes); ++i) out[i] = T(0);
  } else if constexpr (kernel == Kernel::fold) {
    *out = folded(slots[step.in[0]]);
  } else {
    const baseline::Operands<T, kernel, wide> operands(slots, step);
    const bool plain = step.ending == Ending::none && step.factor == no_slot && !step.negated;
    const bool has_factor = step.factor != no_slot;
    const T factor = has_factor ? *slots[step.factor] : T(1);  // a result may overwrite it
    const auto put = [&](const T* x, int i) {
      const auto set = [&](const T& value, T* to) {
        *to = plain ? value : ended(value, to, has_factor ? &factor : nullptr, step);
      };
      if constexpr (kernel == Kernel::cross) {
        T values[3];
        baseline::cross_product(x, values);
        set(values[0], out + i);
        for (std::size_t k = 0; k < 2; ++k) set(values[k + 1], slots[step.also_out[k]] + i);
      } else {
        set(value_of<kernel>(x), out + i);
      }
    };
    if constexpr (wide == 0) {
      put(operands.fixed, 0);
    } else {
#pragma GCC ivdep
      for (int i = 0; i < lanes; ++i) {
        T x[operands.count];
        operands.take(i, x);
        put(x, i);
      }
    }
  }
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

template <class T>
[[nodiscard]] StepFunction<T> function_for(const PlanStep& step) {
  if constexpr (std::is_same_v<T, double>) {
    if (const StepFunction<double> found = wide_steps()(step)) return found;
  }
  switch (step.kernel) {
#define STEP(kernel, ...) \
  case Kernel::kernel:    \
    return choose<T, Kernel::kernel, __VA_ARGS__>(step.wide);
    RIGOR_STEPS(STEP)
    RIGOR_LIBRARY_STEPS(STEP)
#undef STEP
    case Kernel::fold:
      if constexpr (is_here<T, Kernel::fold>) return &run<T, Kernel::fold, 1>;
      break;
    case Kernel::loop:
      break;
  }
  RIGOR_CHECK(false, static_cast<int>(step.kernel));
  return nullptr;
}

}  // namespace kernels
}  // namespace rigor
