// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/evaluate.h"

#include "numeric/run/run_double_double.h"
#include "numeric/run/run_samples.h"

namespace rigor {
namespace {

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
