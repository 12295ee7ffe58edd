// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_samples.h"

#include "base/check.h"

namespace rigor {
namespace {

constexpr std::size_t few_samples = 8;
constexpr std::size_t hardly_any = 3;

}  // namespace

Lanes choose_lanes(const Program& program, const Samples& samples) {
  const bool over_particles = program.sums_over_particles() && samples.samples() < few_samples &&
                              samples.particles() >= many_particles;
  if (over_particles) return Lanes::particles;
  return samples.samples() <= hardly_any ? Lanes::one : Lanes::samples;
}

std::vector<std::uint8_t> varying_inputs(const Program& program, const Samples& samples,
                                         std::span<const std::uint32_t> at) {
  std::vector<std::uint8_t> varies;
  for (const ProgramInput& input : program.inputs()) {
    const Column* column = samples.find(input.symbol, input.component);
    RIGOR_CHECK(column != nullptr, static_cast<std::uint32_t>(input.symbol), input.component);
    varies.push_back(column->sample_stride != 0 ? 1 : 0);
  }
  RIGOR_CHECK(at.size() >= program.free_particles().size(), at.size(), program.free_particles().size());
  for (const std::uint32_t particle : at)
    RIGOR_CHECK(particle < samples.particles(), particle, samples.particles());
  return varies;
}

}  // namespace rigor
