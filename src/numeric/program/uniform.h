// SPDX-License-Identifier: GPL-3.0-or-later
// Uniform numbers from random bits, the same on every machine.
#pragma once

#include "base/splitmix.h"

namespace rigor {

/// A multiple of 2^-53 in [0, 1).
[[nodiscard]] inline double uniform(SplitMix& bits) {
  return static_cast<double>(bits.next() >> 11) * 0x1p-53;
}

/// A multiple of 2^-52 in [-1, 1).
[[nodiscard]] inline double uniform_sign(SplitMix& bits) { return 2 * uniform(bits) - 1; }

}  // namespace rigor
