// SPDX-License-Identifier: GPL-3.0-or-later
// What a real scalar expression is worth in double precision: to doubt a number, or to tell two expressions
// apart before anything exact is asked. It proves nothing.
#pragma once

#include <cmath>
#include <functional>

#include "expr/tree/tree.h"

namespace rigor {

/// Of a real or a complex number.
template <class Number>
[[nodiscard]] Number function_value(Function function, const Number& argument) {
  switch (function) {
    case Function::sin:
      return std::sin(argument);
    case Function::cos:
      return std::cos(argument);
    case Function::exp:
      return std::exp(argument);
    case Function::log:
      return std::log(argument);
    case Function::arcsin:
      return std::asin(argument);
    case Function::arccos:
      return std::acos(argument);
    case Function::arctan:
      return std::atan(argument);
  }
  return Number(NAN);
}

/// NaN where a symbol's value is NaN, and where the expression is no real scalar or is undefined there.
/// Angles are in radians. Errors: those of the operations, so that cancellation can leave no digit.
/// Recursion: as deep as the tree.
[[nodiscard]] double rough_value(const ExprTree& tree, ExprId root,
                                 const std::function<double(SymbolId)>& of_symbol);

}  // namespace rigor
