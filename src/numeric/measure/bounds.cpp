// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/bounds.h"

#include "numeric/run/run_bounded.h"
#include "numeric/run/run_engine.h"
#include "numeric/run/run_samples.h"

namespace rigor {

BoundedResults evaluate_with_bounds(const Program& program, const Samples& samples, double uncertainty,
                                    std::span<const std::uint32_t> at) {
  const std::vector<std::uint8_t> varies = varying_inputs(program, samples, at);
  Engine<Bounded> engine(program.code(), make_plan(program.code(), Lanes::none, varies), samples.particles());
  std::vector<std::vector<Bounded>> columns(program.inputs().size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& column = *samples.find(program.inputs()[i].symbol, program.inputs()[i].component);
    for (std::size_t n = 0; n < column.values.size(); ++n) {
      const double value = column.values[n];
      const double error = uncertainty * std::abs(value) + std::abs(column.low) + column.error(n);
      columns[i].push_back(error == 0.0 ? Bounded(value) : Bounded(value, error + Bounded::least));
    }
    engine.bind(i, {columns[i].data(), column.sample_stride, column.particle_stride});
  }
  for (std::size_t i = 0; i < program.free_particles().size(); ++i) engine.set_free_particle(i, at[i]);
  std::vector<Bounded> results(program.outputs() * samples.samples());
  if (!results.empty()) {
    engine.run_once();
    engine.run(samples.samples(), results.data(), samples.samples());
  }
  BoundedResults separate;
  for (const Bounded& result : results) {
    separate.values.push_back(result.value);
    separate.bounds.push_back(result.bound);
  }
  return separate;
}

}  // namespace rigor
