// SPDX-License-Identifier: GPL-3.0-or-later
// What a program's results are for the given doubles, to many digits: run with 100 and with 200 decimal
// digits, and where these disagree in the first 40, or both give 0, in rational numbers. Where these do not
// do (a root, a function, a long sum) with 400 digits: what still disagrees is unknown, and what falls with
// every digit added, by half of them at least, is called zero.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program.h"
#include "numeric/samples.h"

namespace rigor {

enum class Known : std::uint8_t {
  value,      // to 40 digits at least
  zero,       // exactly 0; behind roots and functions, as far as 400 digits show
  undefined,  // no real value: 0/0, the root of what is negative, an input that is not finite
  unknown,    // the runs disagree
};

struct Reference {
  std::vector<double> values;  // output · samples + sample; the nearest doubles, infinite beyond their range
  std::vector<Known> known;    // the same places
};

[[nodiscard]] Reference reference(const Program& program, const Samples& samples,
                                  std::span<const std::uint32_t> at = {});

}  // namespace rigor
