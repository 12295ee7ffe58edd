// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a program under construction: the same operation on the same operands is the same value.
// A sign is no operation: −a − b, (−a)·b and −(a·b) are exact, so that an operand carries its sign and is
// negated only where a root, a function or a result needs it. A zero and a one that stem from ε, δ, a basis
// or a table leave out terms and factors. Operations on constants are done here where operands and result are
// exact in every arithmetic (24 bits, moderate exponent), so that no rounding is lost. All else is kept.
#pragma once

#include <string>
#include <vector>

#include "numeric/program/code.h"

namespace rigor {

/// A value with a sign: twice the value's number, plus 1 if it is negated.
using Operand = std::uint32_t;

class ValueTable {
 public:
  static constexpr Operand zero = 0;  // leaves its term out
  static constexpr Operand one = 2;   // leaves itself out as a factor
  static constexpr Operand minus_one = 3;

  explicit ValueTable(Code& code);

  [[nodiscard]] static Operand negated(Operand a) { return a == zero ? zero : a ^ 1u; }

  [[nodiscard]] Operand constant(const std::string& digits);
  [[nodiscard]] Operand integer(int value);
  [[nodiscard]] Operand input(std::uint32_t input, std::uint32_t particle);
  [[nodiscard]] Operand add(Operand a, Operand b);
  [[nodiscard]] Operand multiply(Operand a, Operand b);
  [[nodiscard]] Operand divide(Operand a, Operand b);
  /// a² = a·a, a³ = (a·a)·a; even powers are squares: a⁴ = (a²)², a⁶ = (a³)²; 1/aⁿ.
  [[nodiscard]] Operand power(Operand a, int exponent);
  [[nodiscard]] Operand unary(Instruction op, Operand a);
  [[nodiscard]] Operand sum(Operand a, int level);
  /// The value itself, negated by an instruction if need be.
  [[nodiscard]] ValueId value_of(Operand a);

 private:
  [[nodiscard]] Operand exact_constant(double value);
  [[nodiscard]] const double* exact_value(Operand a, double& storage) const;
  [[nodiscard]] Operand number(const Value& value);
  void grow();

  Code* code_;
  std::vector<std::uint32_t> slots_;  // open addressing: value number + 1; 0: empty
};

}  // namespace rigor
