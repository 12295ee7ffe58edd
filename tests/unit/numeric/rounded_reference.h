// SPDX-License-Identifier: GPL-3.0-or-later
// References as doubles, for tests that do not look at the digits beyond.
#pragma once

#include <vector>

#include "numeric/measure/reference.h"

namespace rigor {

/// The nearest doubles, infinite beyond their range.
struct Reference {
  std::vector<double> values;
  std::vector<Known> known;
};

[[nodiscard]] inline Reference reference(const Program& program, const Samples& samples) {
  const ReferenceDigits digits = reference_digits(program, samples);
  Reference result{{}, digits.known};
  for (const ReferenceNumber& value : digits.values) result.values.push_back(static_cast<double>(value));
  return result;
}

}  // namespace rigor
