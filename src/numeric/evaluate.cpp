// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/evaluate.h"

#include "base/check.h"
#include "numeric/run_double_double.h"
#include "numeric/run_samples.h"

namespace rigor {
namespace {

constexpr std::size_t few_samples = 8;
constexpr std::size_t hardly_any = 3;

template <class T>
std::vector<double> rounded(const std::vector<T>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const T& value : values) result.push_back(static_cast<double>(value));
  return result;
}

std::vector<double> rounded(const std::vector<dd_real>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const dd_real& value : values) result.push_back(to_double(value));
  return result;
}

}  // namespace

std::string_view name_of(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::single:
      return "float";
    case Arithmetic::plain:
      return "double";
    case Arithmetic::extended:
      return "long double";
    case Arithmetic::double_double:
      return "double-double";
  }
  return "";
}

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

std::vector<double> evaluate(const Program& program, const Samples& samples, Arithmetic arithmetic,
                             std::span<const std::uint32_t> at) {
  const Lanes lanes = choose_lanes(program, samples);
  switch (arithmetic) {
    case Arithmetic::single:
      return rounded(run_on_samples<float>(program, samples, lanes, at));
    case Arithmetic::plain:
      return run_on_samples<double>(program, samples, lanes, at);
    case Arithmetic::extended:
      return rounded(run_on_samples<long double>(program, samples, lanes, at));
    case Arithmetic::double_double:
      return rounded(run_on_samples<dd_real>(program, samples, lanes, at));
  }
  return {};
}

}  // namespace rigor
