// SPDX-License-Identifier: GPL-3.0-or-later
// References with all their digits: for the sources that compare with them.
#pragma once

#include "numeric/reference.h"
#include "numeric/run_decimal.h"

namespace rigor {

using ReferenceNumber = Decimal<200>;

struct ReferenceDigits {
  std::vector<ReferenceNumber> values;  // as in Reference
  std::vector<Known> known;
};

[[nodiscard]] ReferenceDigits reference_digits(const Program& program, const Samples& samples,
                                               std::span<const std::uint32_t> at);

}  // namespace rigor
