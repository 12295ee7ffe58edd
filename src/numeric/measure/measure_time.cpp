// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>

#include "numeric/measure/measure.h"
#include "numeric/run/run_double_double.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {

extern template class Engine<float>;
extern template class Engine<double>;
extern template class Engine<long double>;
extern template class Engine<dd_real>;

namespace {

using Clock = std::chrono::steady_clock;
constexpr int most_runs = 10'000;

template <class T>
[[nodiscard]] double least_time(const Program& program, const Samples& samples, double milliseconds,
                                std::span<const std::uint32_t> at) {
  SampleEngine<T> engine(program, samples, choose_lanes(program, samples), at);
  const auto end = Clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  double least = 0.0;
  for (int run = 0; run < most_runs; ++run) {
    const auto before = Clock::now();
    engine.run();
    const auto after = Clock::now();
    const double time = std::chrono::duration<double, std::nano>(after - before).count();
    least = run == 0 ? time : std::min(least, time);
    if (after >= end) break;
  }
  return least / static_cast<double>(samples.samples());
}

}  // namespace

double time_of(const Program& program, const Samples& samples, Arithmetic arithmetic, double milliseconds,
               std::span<const std::uint32_t> at) {
  if (samples.samples() == 0 || program.outputs() == 0) return 0.0;
  switch (arithmetic) {
    case Arithmetic::single:
      return least_time<float>(program, samples, milliseconds, at);
    case Arithmetic::plain:
      return least_time<double>(program, samples, milliseconds, at);
    case Arithmetic::extended:
      return least_time<long double>(program, samples, milliseconds, at);
    case Arithmetic::double_double:
      return least_time<dd_real>(program, samples, milliseconds, at);
  }
  return 0.0;
}

}  // namespace rigor
