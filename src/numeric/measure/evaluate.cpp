// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/evaluate.h"

#include <array>

#include "numeric/run/run_double_double.h"
#include "numeric/run/run_samples.h"

namespace rigor {
namespace {

/// Next to `to_double` of QD.
template <class T>
double to_double(const T& value) {
  return static_cast<double>(value);
}

template <class T>
std::vector<double> rounded(const std::vector<T>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const T& value : values) result.push_back(to_double(value));
  return result;
}

}  // namespace

std::string_view name_of(Arithmetic arithmetic) {
  constexpr std::array<std::string_view, arithmetic_count> names{"float", "double", "long double",
                                                                 "double-double"};
  return names[static_cast<std::size_t>(arithmetic)];
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
