// SPDX-License-Identifier: GPL-3.0-or-later
// `run_on_samples` for one kind of number: for the files that instantiate it.
#pragma once

#include <type_traits>

#include "numeric/run/run_engine.h"
#include "numeric/run/run_samples.h"

namespace rigor {

/// With its error, if the number has one.
template <class T>
T input_of(const Column& column, std::size_t n) {
  const double value = column.values[n];
  if constexpr (requires { T::with_error(value, value, value); })
    return T::with_error(value, column.low, column.error(n));
  else
    return column.low == 0 ? T(value) : T(value) + T(column.low);
}

/// The columns of samples as inputs of an engine; those that are not doubles already are rounded here.
template <class T>
class BoundColumns {
 public:
  BoundColumns(Engine<T>& engine, const Program& program, const Samples& samples) {
    for (std::size_t i = 0; i < program.inputs().size(); ++i) {
      const ProgramInput& input = program.inputs()[i];
      const Column& column = *samples.find(input.symbol, input.component);
      const T* data = nullptr;
      if constexpr (std::is_same_v<T, double>) {
        data = column.values.data();
      } else {
        std::vector<T>& own = rounded_.emplace_back();
        own.reserve(column.values.size());
        for (std::size_t n = 0; n < column.values.size(); ++n) own.push_back(input_of<T>(column, n));
        data = own.data();
      }
      engine.bind(i, {data, column.sample_stride, column.particle_stride});
    }
  }

 private:
  std::vector<std::vector<T>> rounded_;
};

template <class T>
std::vector<T> run_on_samples(const Program& program, const Samples& samples, Lanes lanes,
                              std::span<const std::uint32_t> at) {
  if (!NumberTraits<T>::has_lanes) lanes = Lanes::none;
  const std::vector<std::uint8_t> varies = varying_inputs(program, samples, at);
  Engine<T> engine(program.code(), make_plan(program.code(), lanes, varies), samples.particles());
  const BoundColumns<T> columns(engine, program, samples);
  for (std::size_t i = 0; i < program.free_particles().size(); ++i) engine.set_free_particle(i, at[i]);
  std::vector<T> results(program.outputs() * samples.samples(), T(0));
  if (results.empty()) return results;
  engine.run_once();
  engine.run(samples.samples(), results.data(), samples.samples());
  return results;
}

}  // namespace rigor
