// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/bounds.h"

#include <algorithm>
#include <cmath>

#include "numeric/run/run_bounded.h"
#include "numeric/run/run_bounded_decimal.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {
namespace {

using Enclosed = BoundedDecimal<100>;

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// |value − exact|, rounded upwards. What is larger than the decimal's exponents or not bounded is infinite.
double distance(double value, const Enclosed& exact) {
  if (exact.undefined || !exact.bound.is_finite() || !std::isfinite(value)) return unbounded;
  const Magnitude all = Enclosed::size_of(Enclosed::T(exact.value - value)) + exact.bound;
  return all.rounded_up();
}

bool has_low_parts(const Program& program, const Samples& samples) {
  return std::ranges::any_of(program.inputs(), [&](const ProgramInput& input) {
    return samples.find(input.symbol, input.component)->low != 0;
  });
}

}  // namespace

BoundedResults evaluate_with_bounds(const Program& program, const Samples& samples, double uncertainty,
                                    std::span<const std::uint32_t> at) {
  const auto input = [uncertainty](const Column& column, std::size_t n) {
    const double value = column.values[n];
    const double error = uncertainty * std::abs(value) + std::abs(column.low) + column.error(n);
    return error == 0.0 ? Bounded(value) : Bounded(value, error + Bounded::least);
  };
  SampleEngine<Bounded> engine(program, samples, Lanes::none, at, input);
  BoundedResults separate;
  for (const Bounded& result : engine.run()) {
    separate.values.push_back(result.value);
    separate.bounds.push_back(result.bound);
  }
  return separate;
}

std::vector<double> error_bounds(const Program& program, const Samples& samples,
                                 std::span<const double> values) {
  const BoundedResults plain = evaluate_with_bounds(program, samples);
  std::vector<double> bounds;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double apart = std::abs(values[k] - plain.values[k]);
    const double bound = (plain.bounds[k] + apart) * (1 + 0x1p-50);
    bounds.push_back(std::isfinite(bound) ? bound : unbounded);
  }
  // Sums over many particles would take minutes, and what is read in two parts is not what they lack.
  if (program.sums_over_particles() || !has_low_parts(program, samples)) return bounds;
  const auto enclosed = run_on_samples<Enclosed>(program, samples, Lanes::none, {});
  for (std::size_t k = 0; k < values.size(); ++k)
    bounds[k] = std::min(bounds[k], distance(values[k], enclosed[k]));
  return bounds;
}

}  // namespace rigor
