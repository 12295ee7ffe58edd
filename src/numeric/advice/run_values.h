// SPDX-License-Identifier: GPL-3.0-or-later
// A program one value after the other at a single point: for searches that look at all that is computed on
// the way. The engine (`run_engine.h`) gives the same numbers for many points at a time.
#pragma once

#include <span>
#include <vector>

#include "numeric/run/run_numbers.h"

namespace rigor {

/// values[id] for each value of the code, which sums over no particles. T: as for `NumberTraits`.
template <class T>
class ValuesAtPoint {
 public:
  explicit ValuesAtPoint(const Code& code) : code_(&code), values_(code.values.size()) {
    for (const Constant& constant : code.constants) constants_.push_back(number_of<T>(constant));
  }

  /// `inputs`: in the order of the code's own.
  void run(std::span<const double> inputs) {
    for (ValueId id = 0; id < values_.size(); ++id) values_[id] = computed(code_->values[id], inputs);
  }

  [[nodiscard]] const T& operator[](ValueId id) const { return values_[id]; }

 private:
  [[nodiscard]] T computed(const Value& value, std::span<const double> inputs) const {
    using Traits = NumberTraits<T>;
    switch (value.op) {
      case Instruction::constant:
        return constants_[value.a];
      case Instruction::input:
        return T(inputs[value.a]);
      case Instruction::add:
        return values_[value.a] + values_[value.b];
      case Instruction::subtract:
        return values_[value.a] - values_[value.b];
      case Instruction::multiply:
        return values_[value.a] * values_[value.b];
      case Instruction::divide:
        return values_[value.a] / values_[value.b];
      case Instruction::negate:
        return -values_[value.a];
      case Instruction::root:
        return Traits::root(values_[value.a]);
      case Instruction::absolute:
        return Traits::absolute(values_[value.a]);
      case Instruction::sin:
        return Traits::sine(values_[value.a]);
      case Instruction::cos:
        return Traits::cosine(values_[value.a]);
      case Instruction::exp:
        return Traits::exponential(values_[value.a]);
      case Instruction::tan:
        return Traits::tangent(values_[value.a]);
      case Instruction::sinh:
        return Traits::hyperbolic_sine(values_[value.a]);
      case Instruction::cosh:
        return Traits::hyperbolic_cosine(values_[value.a]);
      case Instruction::tanh:
        return Traits::hyperbolic_tangent(values_[value.a]);
      case Instruction::sum:
        break;
    }
    return T(0);
  }

  const Code* code_;
  std::vector<T> constants_;
  std::vector<T> values_;
};

}  // namespace rigor
