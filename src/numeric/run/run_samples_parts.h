// SPDX-License-Identifier: GPL-3.0-or-later
// `run_on_samples` for one kind of number: for the files that instantiate it.
#pragma once

#include <type_traits>

#include "numeric/run/run_engine.h"
#include "numeric/run/run_samples.h"

namespace rigor {

inline constexpr std::size_t many_particles_at_once = 1 << 14;

/// Number n of a column, with its error and with all its digits if T has any.
template <class T>
struct InputOf {
  T operator()(const Column& column, std::size_t n) const {
    const double value = column.values[n];
    if constexpr (requires { T::with_digits(*column.digits); }) {
      if (column.digits != nullptr) return T::with_digits(*column.digits);
    }
    if constexpr (requires { T::with_error(value, value, value); })
      return T::with_error(value, column.low, column.errors.of(n, value));
    else
      return column.low == 0 ? T(value) : T(value) + T(column.low);
  }
};

/// An engine with the columns of samples as its inputs. Where T is no double, numbers become T here, those of
/// many particles a few at a time: no more than the samples' own columns is in memory.
template <class T>
class SampleEngine {
 public:
  template <class Input = InputOf<T>>
  SampleEngine(const Program& program, const Samples& samples, Lanes lanes, std::span<const std::uint32_t> at,
               const Input& input = {})
      : engine_(program.code(), make_plan(program.code(), lanes, varying_inputs(program, samples, at)),
                samples.particles()),
        samples_(samples.samples()),
        results_(program.outputs() * samples_, T(0)) {
    for (std::size_t i = 0; i < program.inputs().size(); ++i) {
      const ProgramInput& named = program.inputs()[i];
      const Column& column = *samples.find(named.symbol, named.component);
      const T* data = nullptr;
      if constexpr (std::is_same_v<T, double>) {
        data = column.values.data();
      } else {
        if (column.sample_stride == 0 && column.values.size() > many_particles_at_once) {
          const auto read = [&column, input](std::size_t begin, std::span<T> into) {
            for (std::size_t k = 0; k < into.size(); ++k) into[k] = input(column, begin + k);
          };
          engine_.bind(i, {nullptr, 0, 1, read});
          continue;
        }
        std::vector<T>& own = rounded_.emplace_back();
        own.reserve(column.values.size());
        for (std::size_t n = 0; n < column.values.size(); ++n) own.push_back(input(column, n));
        data = own.data();
      }
      engine_.bind(i, {data, column.sample_stride, column.particle_stride});
    }
    for (std::size_t i = 0; i < program.free_particles().size(); ++i) engine_.set_free_particle(i, at[i]);
  }

  /// results[output · samples + sample]
  std::vector<T>& run() {
    if (results_.empty()) return results_;
    engine_.run_once();
    engine_.run(samples_, results_.data(), samples_);
    return results_;
  }

 private:
  Engine<T> engine_;
  std::size_t samples_;
  std::vector<T> results_;
  std::vector<std::vector<T>> rounded_;
};

template <class T>
std::vector<T> run_on_samples(const Program& program, const Samples& samples, Lanes lanes,
                              std::span<const std::uint32_t> at) {
  if (!NumberTraits<T>::has_lanes) lanes = Lanes::none;
  return std::move(SampleEngine<T>(program, samples, lanes, at).run());
}

}  // namespace rigor
