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

/// The free indices' values, then the axes of the component of a value of this rank.
[[nodiscard]] inline std::vector<std::uint8_t> axes_of(std::vector<std::uint8_t> indices, int rank,
                                                       std::size_t component) {
  for (std::size_t stride = component_count(rank) / 3; stride > 0; stride /= 3) {
    indices.push_back(static_cast<std::uint8_t>(component / stride % 3 + 1));
  }
  return indices;
}

/// Evaluates both sides for every value of the free indices and calls visit(axes, left, right) for each
/// component, until it returns false; false if it did. The free particles are bound by the caller.
template <class Domain, class Visit>
bool for_each_component(Evaluator<Domain>& evaluator, const ExprTree& tree, const Equation& equation,
                        const Visit& visit) {
  const int rank = tree[equation.left].rank;
  std::vector<std::uint8_t> indices(equation.indices.size(), 1);
  do {
    for (std::size_t i = 0; i < indices.size(); ++i) evaluator.bind(equation.indices[i], indices[i]);
    const auto left = evaluator.array(equation.left);
    const auto right = evaluator.array(equation.right);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!visit(axes_of(indices, rank, i), left[i], right[i])) return false;
    }
  } while (next_tuple<std::uint8_t>(indices, 1, 3));
  return true;
}

}  // namespace rigor
