// SPDX-License-Identifier: GPL-3.0-or-later
// The law of motion of a spin, taken from equations of the notes: each says left − right = 0, affine in the
// rates of the spin's components. Three equations that are independent in the rates determine them.
// Method: the equations are evaluated at the rates 0 and h e_k, which gives their coefficients; Gaussian
// elimination with full pivoting on rows that are scaled by their largest coefficient; the rates are put back
// into all equations. An equation without a rate says nothing about the rates and is passed over; so
// is one with a letter that has no value.
// Error: a few roundings of the coefficients, since h is 2^200, larger than any rate, and (f(h) − f(0))/h
// errs by roundings of f(0)/h.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "expr/statement/statement.h"
#include "scene/motion/letter_values.h"
#include "scene/motion/motion.h"

namespace rigor {

/// left = right for all values of the free indices, with the definitions in force there.
struct LawEquation {
  ExprId left{};
  ExprId right{};
  std::vector<IndexId> indices = {};
  std::vector<Definition> definitions = {};
};

class SpinLaw {
 public:
  /// `spin`: all symbols that the spin goes by (rank 1). `values`: of all other letters; definitions of what
  /// has a value here must have been left out. `at`: a spin at which the equations are tried: that they
  /// determine the rates, are affine in them, and do not contradict each other. Errors name what is wrong.
  [[nodiscard]] static Result<SpinLaw> make(const ExprTree& tree, std::span<const LawEquation> equations,
                                            const std::vector<SymbolId>& spin, const LetterValues& values,
                                            std::size_t particles, const Vector3& at);

  /// In 1/s²; not a number where the equations do not determine them, or contradict each other by more than
  /// 1e-6 of their terms. Not for two threads at once.
  [[nodiscard]] Vector3 rates(const Vector3& spin) const;
  /// Why there are no rates; empty: there are.
  [[nodiscard]] std::string fault_at(const Vector3& spin) const;

 private:
  class System;
  std::shared_ptr<System> system_;
};

}  // namespace rigor
