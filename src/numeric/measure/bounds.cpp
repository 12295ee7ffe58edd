// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/bounds.h"

#include <algorithm>
#include <cmath>

#include "numeric/measure/reference_exact.h"
#include "numeric/run/run_bounded.h"
#include "numeric/run/run_bounded_decimal.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// |value − exact|, rounded upwards. What is larger than the decimal's exponents or not bounded is infinite.
template <unsigned digits>
double distance(double value, const BoundedDecimal<digits>& exact) {
  if (exact.undefined || !exact.bound.is_finite() || !std::isfinite(value)) return unbounded;
  const Magnitude all = exact.size_of(Decimal<digits>(exact.value - value)) + exact.bound;
  return all.rounded_up();
}

bool is_open(double value, double bound) { return bound > 0 && !(bound < std::abs(value)); }

/// Are all inputs known without an error?
bool are_exact(const Program& program, const Samples& samples) {
  return std::ranges::all_of(program.inputs(), [&](const ProgramInput& input) {
    const Column& column = *samples.find(input.symbol, input.component);
    if (column.digits != nullptr) return column.digits->error == 0;
    return column.errors.are_zero();
  });
}

/// Puts in what rational numbers say.
void settle_exactly(const Program& program, const Samples& samples, BoundedResults& results) {
  const ReferenceDigits exact = exact_results(program, samples, {});
  for (std::size_t k = 0; k < results.values.size(); ++k) {
    if (!is_open(results.values[k], results.bounds[k])) continue;
    if (exact.known[k] == Known::zero) results.values[k] = results.bounds[k] = 0;
    if (exact.known[k] != Known::value) continue;
    const double value = static_cast<double>(exact.values[k]);
    const ReferenceNumber rest = abs(exact.values[k] - value) + abs(exact.values[k]) * 0x1p-300;
    results.values[k] = value;
    results.bounds[k] = static_cast<double>(rest) * (1 + 0x1p-50) + 0x1p-1074;
  }
}

/// Puts in what many digits say, where that is more.
template <unsigned digits>
void settle_by_digits(const Program& program, const Samples& samples, BoundedResults& results) {
  const auto enclosed = run_on_samples<BoundedDecimal<digits>>(program, samples, Lanes::none, {});
  for (std::size_t k = 0; k < results.values.size(); ++k) {
    const auto value = static_cast<double>(enclosed[k].value);
    const double bound = distance(value, enclosed[k]);
    if (!(bound < results.bounds[k])) continue;
    results.values[k] = value;
    results.bounds[k] = bound;
  }
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
    const double error = uncertainty * std::abs(value) + std::abs(column.low) + column.errors.of(n, value);
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
  const auto enclosed = run_on_samples<BoundedDecimal<100>>(program, samples, Lanes::none, {});
  for (std::size_t k = 0; k < values.size(); ++k)
    bounds[k] = std::min(bounds[k], distance(values[k], enclosed[k]));
  return bounds;
}

bool have_digits(const Program& program, const Samples& samples) {
  return std::ranges::any_of(program.inputs(), [&](const ProgramInput& input) {
    return samples.find(input.symbol, input.component)->digits != nullptr;
  });
}

BoundedResults enclosures(const Program& program, const Samples& samples, std::vector<double> values) {
  BoundedResults results;
  results.bounds = error_bounds(program, samples, values);
  results.values = std::move(values);
  const auto any_is_open = [&] {
    for (std::size_t k = 0; k < results.values.size(); ++k)
      if (is_open(results.values[k], results.bounds[k])) return true;
    return false;
  };
  if (program.sums_over_particles()) return results;
  if (have_digits(program, samples)) settle_by_digits<100>(program, samples, results);
  if (any_is_open() && are_exact(program, samples)) settle_exactly(program, samples, results);
  if (any_is_open()) settle_by_digits<400>(program, samples, results);
  return results;
}

}  // namespace rigor
