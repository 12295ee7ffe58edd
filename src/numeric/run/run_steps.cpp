// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each instruction set, which CMakeLists.txt names: only built-in types in what runs, as in
// `lanes.h`. Results may overwrite operands: all is lane by lane.
#include "numeric/run/run_steps.h"

#include "numeric/lane/lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {
namespace {

/// Of the operands x, each rounded operation by itself. T is `double` or `Lanes`.
template <Kernel kernel, class T>
RIGOR_INLINE T value_of(const T* x) {
  if constexpr (kernel == Kernel::copy || kernel == Kernel::accumulate) return x[0];
  if constexpr (kernel == Kernel::negate) return -x[0];
  if constexpr (kernel == Kernel::absolute) return absolute(x[0]);
  if constexpr (kernel == Kernel::root) return root(x[0]);
  if constexpr (kernel == Kernel::add) return x[0] + x[1];
  if constexpr (kernel == Kernel::subtract) return x[0] - x[1];
  if constexpr (kernel == Kernel::multiply || kernel == Kernel::accumulate_product) return x[0] * x[1];
  if constexpr (kernel == Kernel::divide) return x[0] / x[1];
  if constexpr (kernel == Kernel::multiply_add) return x[0] * x[1] + x[2];
  if constexpr (kernel == Kernel::multiply_subtract) return x[0] * x[1] - x[2];
  if constexpr (kernel == Kernel::subtract_product) return x[2] - x[0] * x[1];
  if constexpr (kernel == Kernel::product_sum) return x[0] * x[1] + x[2] * x[3];
  if constexpr (kernel == Kernel::product_difference) return x[0] * x[1] - x[2] * x[3];
  if constexpr (kernel == Kernel::product_sum_3) return (x[0] * x[1] + x[2] * x[3]) + x[4] * x[5];
  if constexpr (kernel == Kernel::square_sum_3) return (x[0] * x[0] + x[1] * x[1]) + x[2] * x[2];
  if constexpr (kernel == Kernel::cross_square) {
    const T a = x[0] * x[3] - x[1] * x[4];
    const T b = x[1] * x[5] - x[2] * x[3];
    const T c = x[2] * x[4] - x[0] * x[5];
    return (a * a + b * b) + c * c;
  }
  if constexpr (kernel == Kernel::product_3) return (x[0] * x[1]) * x[2];
  if constexpr (kernel == Kernel::triple_sum_3)
    return (x[0] * x[1] * x[2] + x[3] * x[4] * x[5]) + x[6] * x[7] * x[8];
  if constexpr (kernel == Kernel::add_triple_sum_3)
    return ((x[0] + x[1] * x[2] * x[3]) + x[4] * x[5] * x[6]) + x[7] * x[8] * x[9];
}

/// How many operands a kernel reads, and which one is the narrow factor of its first triple.
constexpr int operands_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::clear:
      return 0;
    case Kernel::add:
    case Kernel::subtract:
    case Kernel::multiply:
    case Kernel::divide:
    case Kernel::accumulate_product:
      return 2;
    case Kernel::multiply_add:
    case Kernel::multiply_subtract:
    case Kernel::subtract_product:
    case Kernel::square_sum_3:
    case Kernel::product_3:
      return 3;
    case Kernel::product_sum:
    case Kernel::product_difference:
      return 4;
    case Kernel::product_sum_3:
    case Kernel::cross_square:
      return 6;
    case Kernel::triple_sum_3:
      return 9;
    case Kernel::add_triple_sum_3:
      return 10;
    default:
      return 1;
  }
}
constexpr int first_narrow_of(Kernel kernel) {
  return kernel == Kernel::triple_sum_3       ? 1
         : kernel == Kernel::add_triple_sum_3 ? 2
                                              : static_cast<int>(most_operands);
}

template <Kernel kernel, unsigned wide>
struct Operands {
  static constexpr int count = operands_of(kernel);
  const double* from[count];
  double fixed[count];  // what is not wide; in triples with the sign, which is exact

  RIGOR_INLINE Operands(double* const* slots, const PlanStep& step) {
    SlotId in[most_operands];
    __builtin_memcpy(in, &step.in, sizeof in);
    for (int k = 0; k < count; ++k) {
      from[k] = slots[in[k]];
      if ((wide >> k & 1) != 0) continue;
      fixed[k] = *from[k];
      const int triple = (k - first_narrow_of(kernel)) / 3;
      if (k >= first_narrow_of(kernel) && (step.minus >> triple & 1) != 0) fixed[k] = -fixed[k];
    }
  }

  RIGOR_INLINE Lanes lanes_at(int i) const {
    Lanes x[count];
    for (int k = 0; k < count; ++k) x[k] = (wide >> k & 1) != 0 ? load(from[k] + i) : all<Lanes>(fixed[k]);
    return value_of<kernel>(x);
  }
  RIGOR_INLINE double at(int i) const {
    double x[count];
    for (int k = 0; k < count; ++k) x[k] = (wide >> k & 1) != 0 ? from[k][i] : fixed[k];
    return value_of<kernel>(x);
  }
};

template <Kernel kernel, unsigned wide>
void run_step(double* const* slots, const PlanStep& step, int count) {
  double* const out = slots[step.out];
  if constexpr (kernel == Kernel::clear) {
    for (int i = 0; i < lane_count; i += lanes) store(out + i, Lanes{});
  } else if constexpr (kernel == Kernel::accumulate || kernel == Kernel::accumulate_product) {
    // Lanes that hold no particle are not added to.
    const Operands<kernel, wide> x(slots, step);
    const int here = step.over_lanes ? count : lane_count;
    int i = 0;
    for (; i + lanes <= here; i += lanes) store(out + i, load(out + i) + x.lanes_at(i));
    for (; i < here; ++i) out[i] = out[i] + x.at(i);
  } else {
    const Operands<kernel, wide> x(slots, step);
    for (int i = 0; i < lane_count; i += lanes) store(out + i, x.lanes_at(i));
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

template <Kernel kernel, unsigned... choices>
StepFunction<double> choose(unsigned wide) {
  StepFunction<double> chosen = nullptr;
  static_cast<void>(((wide == choices ? (chosen = &run_step<kernel, choices>, true) : false) || ...));
  return chosen;
}

/// Operands are wide in the order in which `run_fuse.h` puts them.
StepFunction<double> found_step(const PlanStep& step) {
#define CASE(kernel, ...) \
  case Kernel::kernel:    \
    return choose<Kernel::kernel, __VA_ARGS__>(step.wide)
  switch (step.kernel) {
    CASE(clear, 0x8000);
    CASE(copy, 0x8000, 0x8001);
    CASE(negate, 0x8001);
    CASE(absolute, 0x8001);
    CASE(root, 0x8001);
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
      return &fold;
    default:
      return nullptr;
  }
#undef CASE
}

}  // namespace

extern const FindStep find_step;
const FindStep find_step = found_step;

}  // namespace rigor::RIGOR_INSTRUCTION_SET
