// SPDX-License-Identifier: GPL-3.0-or-later
// What a program's results are for the given doubles, to 40 digits at least: run with 100 decimal digits and
// a running error bound (`run_bounded_decimal.h`). Samples where the bound is too large are run in rational
// numbers (where they have them, and these do not grow too long), then with 400 and 1,400 digits. What is not
// known to 40 digits then is unknown: so is a 0 after a root or a function that is not rational.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

enum class Known : std::uint8_t {
  value,      // to 40 digits at least, proved by a bound or by rational numbers
  zero,       // exactly 0, in rational numbers
  undefined,  // proved to have no real value: 0/0, the root of what is negative, an input that is not finite
  unknown,    // none of these is proved; so is what is beyond 1e±300,000,000
};

using ReferenceNumber = Decimal<100>;

struct ReferenceDigits {
  std::vector<ReferenceNumber> values;  // output · samples + sample; 0 where they are not known
  std::vector<Known> known;             // the same places
};

[[nodiscard]] ReferenceDigits reference_digits(const Program& program, const Samples& samples,
                                               std::span<const std::uint32_t> at = {});

}  // namespace rigor
