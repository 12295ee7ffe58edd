// SPDX-License-Identifier: GPL-3.0-or-later
// Products. Among vectors `\times` binds tighter than `\cdot`, and `\cdot` tighter than juxtaposition;
// scalars are anywhere. Where that leaves two readings (A×B×C, a/bc) the answer is a diagnostic.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// A factor, and what comes before it.
struct Operand {
  Typed typed;
  Joint joint;
  Span joint_span;
};

/// `ab/c` divides all that is before; `1/2 m` is one half of m; `a/b c` has two readings.
[[nodiscard]] MaybeTyped product_of(Reading& reading, std::vector<Operand> operands, Span span);
[[nodiscard]] MaybeTyped divide(Reading& reading, const Typed& dividend, const Typed& divisor, Span span);

}  // namespace rigor
