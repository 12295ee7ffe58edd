// SPDX-License-Identifier: GPL-3.0-or-later
// Forms that nobody would write, always the same ones.
#pragma once

#include <random>

#include "expr/build.h"

namespace rigor::build {

/// Random forms of vectors A, B and scalars x, y.
class RandomForms {
 public:
  [[nodiscard]] Term scalar(int depth) {
    if (depth == 0)
      return pick(2) == 0 ? Term(at(page.vectors_of[pick(2)], 1 + pick(3))) : page.number_of(pick(4));
    switch (pick(9)) {
      case 0:
        return scalar(depth - 1) + scalar(depth - 1);
      case 1:
        return scalar(depth - 1) - scalar(depth - 1);
      case 2:
        return scalar(depth - 1) * scalar(depth - 1);
      case 3:
        return scalar(depth - 1) / scalar(depth - 1);
      case 4:
        return dot(vector(depth - 1), vector(depth - 1));
      case 5:
        return pow(scalar(depth - 1), 2 + pick(3));
      case 6:
        return length(vector(depth - 1));
      case 7:
        return sin(scalar(depth - 1)) + cos(scalar(depth - 1));
      default:
        return root(absolute(scalar(depth - 1)));
    }
  }
  [[nodiscard]] Term vector(int depth) {
    if (depth == 0) return page.vectors_of[pick(2)];
    return pick(2) == 0 ? cross(vector(depth - 1), vector(depth - 1)) : scalar(depth - 1) * vector(depth - 1);
  }
  [[nodiscard]] int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  struct Vectors : Page {
    Named vectors_of[2] = {vector("A"), vector("B")};
    [[nodiscard]] Term number_of(int k) {
      const char* digits[] = {"2", "0.1", "3", "1.7"};
      return number(digits[k]);
    }
  } page;

 private:
  std::mt19937 random_{7};
};

}  // namespace rigor::build
