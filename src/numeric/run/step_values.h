// SPDX-License-Identifier: GPL-3.0-or-later
// What each step computes, once for all kinds of number: T is `double` or `Lanes`, or any other for which a
// program runs. Each operation is rounded by itself.
#pragma once

#include "numeric/lane/lanes.h"
#include "numeric/program/run_plan.h"

/// The steps, each with the choices of wide operands that there are, in the order in which `run_fuse.h` puts
/// them, beside that of none. Of doubles, the functions of the standard library have no lanes of their own.
#define RIGOR_STEPS(STEP)                                  \
  STEP(clear, 0x8000)                                      \
  STEP(copy, 0x8000, 0x8001)                               \
  STEP(negate, 0x8001)                                     \
  STEP(absolute, 0x8001)                                   \
  STEP(root, 0x8001)                                       \
  STEP(add, 0x8001, 0x8003)                                \
  STEP(subtract, 0x8001, 0x8002, 0x8003)                   \
  STEP(multiply, 0x8001, 0x8003)                           \
  STEP(divide, 0x8001, 0x8002, 0x8003)                     \
  STEP(multiply_add, 0x8001, 0x8003, 0x8005, 0x8007)       \
  STEP(multiply_subtract, 0x8001, 0x8003, 0x8005, 0x8007)  \
  STEP(subtract_product, 0x8001, 0x8003, 0x8005, 0x8007)   \
  STEP(product_sum, 0x8005, 0x8007, 0x800d, 0x800f)        \
  STEP(product_difference, 0x8005, 0x8007, 0x800d, 0x800f) \
  STEP(product_sum_3, 0x8015, 0x803f)                      \
  STEP(square_sum_3, 0x8007)                               \
  STEP(cross_square, 0x8007, 0x803f)                       \
  STEP(cross, 0x8007, 0x803f)                              \
  STEP(gram, 0x803f)                                       \
  STEP(less_square, 0x8055, 0x80ff)                        \
  STEP(product_3, 0x8001, 0x8003, 0x8005, 0x8007)          \
  STEP(triple_sum_3, 0x816d)                               \
  STEP(add_triple_sum_3, 0x82db)                           \
  STEP(quadratic_form_3, 0x8007)
#define RIGOR_LIBRARY_STEPS(STEP) \
  STEP(sin, 0x8001)               \
  STEP(cos, 0x8001)               \
  STEP(exp, 0x8001)               \
  STEP(tan, 0x8001)               \
  STEP(sinh, 0x8001)              \
  STEP(cosh, 0x8001)              \
  STEP(tanh, 0x8001)

namespace rigor::RIGOR_INSTRUCTION_SET {

/// Of the operands x. What is a function of one number is not here, but for those that lanes have.
template <Kernel kernel, class T>
RIGOR_INLINE T value_of(const T* x) {
  if constexpr (kernel == Kernel::copy) return x[0];
  if constexpr (kernel == Kernel::negate) return -x[0];
  if constexpr (kernel == Kernel::absolute) return absolute(x[0]);
  if constexpr (kernel == Kernel::root) return root(x[0]);
  if constexpr (kernel == Kernel::add) return x[0] + x[1];
  if constexpr (kernel == Kernel::subtract) return x[0] - x[1];
  if constexpr (kernel == Kernel::multiply) return x[0] * x[1];
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
  if constexpr (kernel == Kernel::gram) {
    const T a = (x[0] * x[0] + x[1] * x[1]) + x[2] * x[2];
    const T b = (x[3] * x[3] + x[4] * x[4]) + x[5] * x[5];
    const T c = (x[0] * x[3] + x[1] * x[4]) + x[2] * x[5];
    return a * b - c * c;
  }
  if constexpr (kernel == Kernel::less_square) {
    const T c = (x[2] * x[3] + x[4] * x[5]) + x[6] * x[7];
    return x[0] * x[1] - c * c;
  }
  if constexpr (kernel == Kernel::product_3) return (x[0] * x[1]) * x[2];
  if constexpr (kernel == Kernel::triple_sum_3)
    return (x[0] * x[1] * x[2] + x[3] * x[4] * x[5]) + x[6] * x[7] * x[8];
  if constexpr (kernel == Kernel::add_triple_sum_3)
    return ((x[0] + x[1] * x[2] * x[3]) + x[4] * x[5] * x[6]) + x[7] * x[8] * x[9];
  if constexpr (kernel == Kernel::quadratic_form_3) {
    T sum = x[0] * x[3] * x[0];
    for (int n = 1; n < 9; ++n) sum = sum + x[n / 3] * x[3 + n] * x[n % 3];
    return sum;
  }
}

/// A step has one result, a cross product three.
constexpr int results_of(Kernel kernel) { return kernel == Kernel::cross ? 3 : 1; }

template <class T>
RIGOR_INLINE void cross_product(const T* x, T* result) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    result[i] = x[j] * x[3 + k] - x[k] * x[3 + j];
  }
}

/// How many operands a kernel reads.
constexpr int operands_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::clear:
      return 0;
    case Kernel::add:
    case Kernel::subtract:
    case Kernel::multiply:
    case Kernel::divide:
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
    case Kernel::cross:
    case Kernel::gram:
      return 6;
    case Kernel::less_square:
      return 8;
    case Kernel::triple_sum_3:
      return 9;
    case Kernel::add_triple_sum_3:
      return 10;
    case Kernel::quadratic_form_3:
      return 12;
    default:
      return 1;
  }
}

/// Which triple the sign of this operand is that of; −1: none.
constexpr int triple_of(Kernel kernel, int operand) {
  const int first = kernel == Kernel::triple_sum_3 ? 1 : kernel == Kernel::add_triple_sum_3 ? 2 : 0;
  if (kernel == Kernel::quadratic_form_3) return operand - 3;
  return first != 0 && operand >= first && (operand - first) % 3 == 0 ? (operand - first) / 3 : -1;
}

/// The operands of a step: pointers to what is wide, and the others as numbers; in triples with the sign,
/// which is exact.
template <class T, Kernel kernel, unsigned wide>
struct Operands {
  static constexpr int count = operands_of(kernel);
  const T* from[count];
  T fixed[count];

  RIGOR_INLINE Operands(T* const* slots, const PlanStep& step) {
    const auto* const in = reinterpret_cast<const SlotId*>(&step.in);  // no function of a library
    for (int k = 0; k < count; ++k) {
      from[k] = slots[in[k]];
      if ((wide >> k & 1) != 0) continue;
      fixed[k] = *from[k];
      const int triple = triple_of(kernel, k);
      if (triple >= 0 && (step.minus >> triple & 1) != 0) fixed[k] = -fixed[k];
    }
  }

  /// Of lane i.
  RIGOR_INLINE void take(int i, T* x) const {
    for (int k = 0; k < count; ++k) x[k] = (wide >> k & 1) != 0 ? from[k][i] : fixed[k];
  }
};

}  // namespace rigor::RIGOR_INSTRUCTION_SET
