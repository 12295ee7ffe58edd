// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each instruction set, which CMakeLists.txt names: only built-in types in what runs, as in
// `lanes.h`. Results may overwrite operands: all is lane by lane.
#include "numeric/run/run_steps.h"

#include "numeric/run/step_values.h"

namespace rigor::RIGOR_INSTRUCTION_SET {
namespace {

template <Kernel kernel, class T>
RIGOR_INLINE void values_of(const T* x, T* values) {
  if constexpr (kernel == Kernel::cross)
    cross_product(x, values);
  else
    values[0] = value_of<kernel>(x);
}

template <Kernel kernel, unsigned wide>
struct LaneOperands : Operands<double, kernel, wide> {
  using Operands<double, kernel, wide>::Operands;

  RIGOR_INLINE void lanes_at(int i, Lanes* values) const {
    Lanes x[this->count];
    for (int k = 0; k < this->count; ++k)
      x[k] = (wide >> k & 1) != 0 ? load(this->from[k] + i) : all<Lanes>(this->fixed[k]);
    values_of<kernel>(x, values);
  }
  RIGOR_INLINE void at(int i, double* values) const {
    double x[this->count];
    this->take(i, x);
    values_of<kernel>(x, values);
  }
};

/// The factor or divisor at the end of a step. A product by ±1 is exact.
RIGOR_INLINE double factor_of(double* const* slots, const PlanStep& step) {
  const double factor = step.factor == no_slot ? 1 : *slots[step.factor];
  return step.negated ? -factor : factor;
}

template <Kernel kernel, unsigned wide, Ending ending>
void run_step(double* const* slots, const PlanStep& step, int count) {
  const int computed = (count + lane_step - 1) / lane_step * lane_step;
  if constexpr (kernel == Kernel::clear) {
    double* const out = slots[step.out];
    for (int i = 0; i < computed; i += lanes) store(out + i, Lanes{});
  } else {
    const LaneOperands<kernel, wide> x(slots, step);
    const double factor = factor_of(slots, step);
    constexpr int results = results_of(kernel);
    double* out[results] = {slots[step.out]};
    const auto* const more = reinterpret_cast<const SlotId*>(&step.also_out);
    for (int k = 1; k < results; ++k) out[k] = slots[more[k - 1]];
    // Lanes that hold no particle are not added to.
    int i = 0;
    for (; i + lanes <= (ending == Ending::add ? count : computed); i += lanes) {
      Lanes v[results];
      Lanes before[results];
      // All loads come first: see `fitting_samples`.
      for (int k = 0; k < results; ++k)
        if constexpr (ending == Ending::add) before[k] = load(out[k] + i);
      x.lanes_at(i, v);
      for (int k = 0; k < results; ++k) {
        const Lanes last = ending == Ending::divide ? v[k] / factor : v[k] * factor;
        store(out[k] + i, ending == Ending::add ? before[k] + last : last);
      }
    }
    for (; ending == Ending::add && i < count; ++i) {
      double v[results];
      x.at(i, v);
      for (int k = 0; k < results; ++k) out[k][i] = out[k][i] + v[k] * factor;
    }
  }
}

/// The upper half of the lanes is added to the lower one until one number is left.
void fold(double* const* slots, const PlanStep& step, int) {
  SlotId in[most_operands];
  __builtin_memcpy(in, &step.in, sizeof in);
  double* const sums = slots[in[0]];
  int half = lane_count / 2;
  for (; half >= lanes; half /= 2)
    for (int i = 0; i < half; i += lanes) store(sums + i, load(sums + i) + load(sums + i + half));
  for (; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) sums[i] = sums[i] + sums[i + half];
  *slots[step.out] = sums[0];
}

template <Kernel kernel, unsigned wide>
constexpr StepFunction<double> with_ending[] = {&run_step<kernel, wide, Ending::none>,
                                                &run_step<kernel, wide, Ending::divide>,
                                                &run_step<kernel, wide, Ending::add>};

template <Kernel kernel, unsigned... choices>
StepFunction<double> choose(const PlanStep& step) {
  StepFunction<double> chosen = nullptr;
  const auto ending = static_cast<int>(step.ending);
  static_cast<void>(
      ((step.wide == choices ? (chosen = with_ending<kernel, choices>[ending], true) : false) || ...));
  return chosen;
}

StepFunction<double> found_step(const PlanStep& step) {
  switch (step.kernel) {
#define STEP(kernel, ...) \
  case Kernel::kernel:    \
    return choose<Kernel::kernel, __VA_ARGS__>(step);
    RIGOR_STEPS(STEP)
#undef STEP
    case Kernel::fold:
      return &fold;
    default:
      return nullptr;
  }
}

}  // namespace

extern const FindStep find_step;
const FindStep find_step = found_step;

}  // namespace rigor::RIGOR_INSTRUCTION_SET
