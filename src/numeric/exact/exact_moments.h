// SPDX-License-Identifier: GPL-3.0-or-later
// Principal moments of a tensor in integers, with a proof of every digit.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "numeric/exact/long_number.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {

struct ExactTensor;

/// Which moments are equal is told exactly: from the discriminant D of the characteristic polynomial χ, in
/// integers. Where D = 0, all roots are rational, therefore integers over the divisor, and their error is 0.
/// Else they are found by Jacobi's rotations in 256, 1,024 or 4,096 bits, until each gap stands out, and χ
/// changes its sign across each enclosure, in integers: as these are apart, each holds one root.
struct ExactMoments {
  std::array<LongNumber, 3> moments;  // ascending
  /// Rounded: the moments to 2^-104 of themselves and their errors, the gaps to 2^-52; a gap is 0 only where
  /// it is.
  PrincipalMoments principal;
  /// Where moments are equal, some choice; to 2^-52 else.
  std::array<Position, 3> axes{};
};

/// Cost: 20 us where the entries have 300 bits. Nothing where a moment or the divisor leaves the range of
/// doubles, or where gaps are below 2^-4000 of a moment.
[[nodiscard]] std::optional<ExactMoments> exact_moments(const ExactTensor& tensor);

}  // namespace rigor
