// SPDX-License-Identifier: GPL-3.0-or-later
// A program on samples, with results in the numbers that it was computed with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program/run_plan.h"
#include "numeric/program/samples.h"

namespace rigor {

/// Samples in lanes, unless there are few samples and many particles to sum over.
[[nodiscard]] Lanes choose_lanes(const Program& program, const Samples& samples);

/// For each input of the program, whether it is another one for each sample. An input without values, or a
/// particle that is not there, is our own bug.
[[nodiscard]] std::vector<std::uint8_t> varying_inputs(const Program& program, const Samples& samples,
                                                       std::span<const std::uint32_t> at);

/// results[output · samples + sample]. T: float, double, long double, dd_real, and what `run_*.cpp` adds.
/// Lanes make no difference to a sample's result but in the order of sums over particles: over lanes of
/// particles, each lane adds up its own, and then the upper half of the lanes is added to the lower one, and
/// so on. That is the order of each sum at level 1 that depends on no sample, for any number of particles,
/// unless `lanes` is none; and of each sum at level 1 where `lanes` is particles. Other sums add one particle
/// after the other.
template <class T>
[[nodiscard]] std::vector<T> run_on_samples(const Program& program, const Samples& samples, Lanes lanes,
                                            std::span<const std::uint32_t> at);

}  // namespace rigor
