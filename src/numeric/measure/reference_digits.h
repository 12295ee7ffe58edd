// SPDX-License-Identifier: GPL-3.0-or-later
// References with all their digits: for the sources that compare with them.
#pragma once

#include "numeric/measure/reference.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

using ReferenceNumber = Decimal<100>;

struct ReferenceDigits {
  std::vector<ReferenceNumber> values;  // as in Reference; 0 where they are not known
  std::vector<Known> known;
};

[[nodiscard]] ReferenceDigits reference_digits(const Program& program, const Samples& samples,
                                               std::span<const std::uint32_t> at);

}  // namespace rigor
