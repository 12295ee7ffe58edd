// SPDX-License-Identifier: GPL-3.0-or-later
// The components of an equation, one after the other.
#pragma once

#include <vector>

#include "algebra/evaluator/evaluator.h"

namespace rigor {

/// Counts up a tuple of numbers from `first` to `last`, the last one fastest; false after the last tuple.
template <class Digit>
[[nodiscard]] bool next_tuple(std::vector<Digit>& tuple, Digit first, Digit last) {
  for (auto digit = tuple.rbegin(); digit != tuple.rend(); ++digit) {
    if (*digit < last) {
      ++*digit;
      return true;
    }
    *digit = first;
  }
  return false;
}

/// Counts up axes from 1, the last one fastest, each to the dimension of its space; false after the last.
[[nodiscard]] inline bool next_axes(std::vector<std::uint8_t>& axes,
                                    const std::vector<std::uint8_t>& dimensions) {
  for (std::size_t k = axes.size(); k-- > 0;) {
    if (axes[k] < dimensions[k]) {
      ++axes[k];
      return true;
    }
    axes[k] = 1;
  }
  return false;
}

/// The dimensions of the free indices' spaces, then of the axes of the sides.
[[nodiscard]] inline std::vector<std::uint8_t> dimensions_of(const ExprTree& tree, const Equation& equation) {
  std::vector<std::uint8_t> dimensions;
  for (const IndexId index : equation.indices) dimensions.push_back(tree.space(index).dimension);
  const ExprNode& side = tree[equation.left];
  for (int axis = 0; axis < side.rank; ++axis) dimensions.push_back(side.axes[axis].dimension);
  return dimensions;
}

/// Evaluates both sides for every value of the free indices and calls visit(axes, left, right) for each
/// component, until it returns false; false if it did. The axes are the free indices' values, then those of
/// the component. The free particles are bound by the caller.
template <class Domain, class Visit>
bool for_each_component(Evaluator<Domain>& evaluator, const ExprTree& tree, const Equation& equation,
                        const Visit& visit) {
  const std::vector<std::uint8_t> dimensions = dimensions_of(tree, equation);
  const std::size_t free = equation.indices.size();
  std::vector<std::uint8_t> axes(dimensions.size(), 1);
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < free; ++i) evaluator.bind(equation.indices[i], axes[i]);
    const auto left = evaluator.array(equation.left);
    const auto right = evaluator.array(equation.right);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!visit(axes, left[i], right[i])) return false;
      more = next_axes(axes, dimensions);
    }
  }
  return true;
}

}  // namespace rigor
