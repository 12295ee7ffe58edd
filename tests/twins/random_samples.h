// SPDX-License-Identifier: GPL-3.0-or-later
// What exact random samples say about a statement, whatever was decided: for the test that nothing proved
// fails.
#pragma once

#include <cstdint>
#include <optional>

#include "algebra/decide/decide.h"

namespace rigor {

struct RandomSamples {
  std::uint32_t compared = 0;    // different samples that meet the assumptions and give both sides a value
  std::optional<Sample> failed;  // the first on which the sides are not related as the claim says
};

/// Looks at up to `wanted` samples from a seed of its own, with the definitions unfolded; ends early where
/// few meet the assumptions, or where the limits are reached.
[[nodiscard]] RandomSamples try_random_samples(const Question& question, std::uint32_t wanted,
                                               std::uint64_t seed, const Limits& limits = {});

}  // namespace rigor
