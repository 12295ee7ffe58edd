// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "numeric/body/body.h"

namespace rigor {

/// The moments by the trigonometric formula, I_k = q + 2 p cos(φ + 2πk/3), as a symbolic expression into
/// which numbers are put: what a computer algebra system does with a formula. 17 digits.
class GinacMoments {
 public:
  GinacMoments();
  ~GinacMoments();
  GinacMoments(const GinacMoments&) = delete;
  GinacMoments& operator=(const GinacMoments&) = delete;

  /// Ascending. NaN where GiNaC finds no real number.
  [[nodiscard]] Position evaluate(const InertiaTensor& tensor) const;

 private:
  struct Formula;
  std::unique_ptr<Formula> formula_;
};

}  // namespace rigor
