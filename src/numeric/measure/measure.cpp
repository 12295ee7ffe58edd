// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"
#include "numeric/measure/condition.h"
#include "numeric/measure/reference.h"
#include "numeric/run/run_double_double.h"
#include "numeric/run/run_samples.h"

namespace rigor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t timed_samples = 1024;

/// Length of the significand, and the least exponent of a unit in the last place.
struct Precision {
  int bits = 0;
  int least = 0;
};

/// By arithmetic.
constexpr std::array<Precision, arithmetic_count> precisions{
    {{24, -149}, {53, -1074}, {64, -16445}, {106, -1074}}};

[[nodiscard]] ReferenceNumber exactly(const dd_real& x) {
  return ReferenceNumber(x.x[0]) + ReferenceNumber(x.x[1]);
}
template <class T>
[[nodiscard]] ReferenceNumber exactly(const T& x) {
  return ReferenceNumber(x);
}
[[nodiscard]] bool is_nan(const dd_real& x) { return x.isnan(); }
template <class T>
[[nodiscard]] bool is_nan(const T& x) {
  return std::isnan(x);
}
/// Of a double-double, both parts.
[[nodiscard]] bool is_finite(const dd_real& x) { return std::isfinite(x.x[0]) && std::isfinite(x.x[1]); }
template <class T>
[[nodiscard]] bool is_finite(const T& x) {
  return std::isfinite(x);
}

[[nodiscard]] Spread spread_of(std::vector<double> values, bool least_is_worst = false) {
  if (values.empty()) return {};
  for (const double value : values) RIGOR_CHECK(!std::isnan(value), values.size());  // they have no order
  std::ranges::sort(values);
  return {least_is_worst ? values.front() : values.back(), values[values.size() / 2]};
}

/// One arithmetic against the exact values, sample by sample.
class Comparison {
 public:
  Comparison(Arithmetic arithmetic, std::size_t outputs, const ReferenceDigits& exact)
      : precision_(precisions[static_cast<std::size_t>(arithmetic)]),
        outputs_(outputs),
        samples_(outputs == 0 ? 0 : exact.values.size() / outputs),
        exact_(exact) {
    result_.arithmetic = arithmetic;
    result_.right_bits = precision_.bits;
  }

  template <class T>
  [[nodiscard]] ErrorMeasure against(const std::vector<T>& computed) {
    for (std::size_t sample = 0; sample < samples_; ++sample) add(computed, sample);
    result_.relative = spread_of(std::move(relative_));
    result_.ulps = spread_of(std::move(ulps_));
    result_.bits_kept = spread_of(std::move(bits_), true);
    return result_;
  }

 private:
  [[nodiscard]] std::size_t count(Known known, std::size_t sample) const {
    std::size_t found = 0;
    for (std::size_t k = 0; k < outputs_; ++k) found += exact_.known[k * samples_ + sample] == known ? 1 : 0;
    return found;
  }

  template <class T>
  void add(const std::vector<T>& computed, std::size_t sample) {
    if (count(Known::undefined, sample) > 0) {
      ++result_.undefined;
      return;
    }
    if (count(Known::unknown, sample) > 0) {
      ++result_.unknown;
      return;
    }
    ReferenceNumber size = 0;
    ReferenceNumber error = 0;
    ReferenceNumber largest = 0;
    bool nan = false;
    bool infinite = false;
    for (std::size_t k = 0; k < outputs_; ++k) {
      const T& value = computed[k * samples_ + sample];
      const ReferenceNumber& exact = exact_.values[k * samples_ + sample];
      nan = nan || is_nan(value);
      infinite = infinite || !is_finite(value);
      size = std::max(size, ReferenceNumber(abs(exact)));
      if (infinite) continue;
      largest = std::max(largest, ReferenceNumber(abs(exactly(value))));
      error = std::max(error, ReferenceNumber(abs(exactly(value) - exact)));
    }
    if (count(Known::zero, sample) == outputs_) {
      ++result_.zeros;
      const double at_zero = infinite ? infinity : static_cast<double>(largest);
      result_.worst_at_zero = std::max(result_.worst_at_zero, at_zero);
      return;
    }
    ++result_.compared;
    if (outputs_ == 1 && !nan) {
      const ReferenceNumber value = exactly(computed[sample]);
      if (value * exact_.values[sample] <= 0) ++result_.wrong_signs;
    }
    if (infinite) {
      ++(nan ? result_.not_a_number : result_.overflows);
      if (!nan && size > std::numeric_limits<double>::max()) --result_.overflows;
      relative_.push_back(infinity);
      ulps_.push_back(infinity);
      bits_.push_back(0.0);
      return;
    }
    add_error(error, size);
  }

  void add_error(const ReferenceNumber& error, const ReferenceNumber& size) {
    const double relative = static_cast<double>(ReferenceNumber(error / size));
    const int exponent = ilogb(size);
    const int last = std::max(exponent - precision_.bits + 1, precision_.least);
    relative_.push_back(relative);
    ulps_.push_back(static_cast<double>(ReferenceNumber(ldexp(error, -last))));
    bits_.push_back(relative == 0.0 ? result_.right_bits
                                    : std::clamp(-std::log2(relative), 0.0, result_.right_bits));
  }

  Precision precision_;
  std::size_t outputs_;
  std::size_t samples_;
  const ReferenceDigits& exact_;
  ErrorMeasure result_;
  std::vector<double> relative_;
  std::vector<double> ulps_;
  std::vector<double> bits_;
};

template <class T>
[[nodiscard]] ErrorMeasure compare(Arithmetic arithmetic, const Program& program, const Samples& samples,
                                   const ReferenceDigits& exact, std::span<const std::uint32_t> at) {
  const std::vector<T> computed = run_on_samples<T>(program, samples, choose_lanes(program, samples), at);
  return Comparison(arithmetic, program.outputs(), exact).against(computed);
}

/// What overflows when its inputs are rounded to float is an overflow, not an undefined value.
[[nodiscard]] ErrorMeasure compare_single(const Program& program, const Samples& samples,
                                          const ReferenceDigits& exact, std::span<const std::uint32_t> at) {
  const Samples rounded = samples.rounded_to_float();
  const ReferenceDigits of_rounded = reference_digits(program, rounded, at);
  ErrorMeasure measure = compare<float>(Arithmetic::single, program, rounded, of_rounded, at);
  for (std::size_t sample = 0; sample < samples.samples(); ++sample) {
    bool lost = false;
    bool defined = true;
    for (std::size_t k = 0; k < program.outputs(); ++k) {
      const std::size_t i = k * samples.samples() + sample;
      lost = lost || of_rounded.known[i] == Known::undefined;
      defined = defined && exact.known[i] != Known::undefined;
    }
    if (!lost || !defined) continue;
    --measure.undefined;
    ++measure.overflows;
  }
  return measure;
}

[[nodiscard]] Samples first_of(const Samples& samples, std::size_t count) {
  std::vector<std::size_t> which(count);
  std::iota(which.begin(), which.end(), std::size_t{0});
  return samples.only(which);
}

/// The samples again and again, up to 1,024 of them; fewer where each takes long.
[[nodiscard]] Samples repeated(const Program& program, const Samples& samples) {
  if (samples.samples() < 2) return samples;
  const std::size_t affordable = 4'000'000 / work_of(program, samples);
  const std::size_t count = std::clamp(affordable, std::size_t{64}, timed_samples);
  std::vector<std::size_t> which(std::max(count, std::min(samples.samples(), affordable)));
  for (std::size_t i = 0; i < which.size(); ++i) which[i] = i % samples.samples();
  return samples.only(which);
}

}  // namespace

FormMeasure measure(const Program& program, const Samples& samples, const MeasureOptions& options,
                    std::span<const std::uint32_t> at) {
  FormMeasure result;
  const std::size_t affordable = options.operations / work_of(program, samples);
  result.measured = std::min(samples.samples(), affordable);
  const Samples measured =
      result.measured == samples.samples() ? samples : first_of(samples, result.measured);
  const ReferenceDigits exact = reference_digits(program, measured, at);
  result.arithmetics = {
      compare_single(program, measured, exact, at),
      compare<double>(Arithmetic::plain, program, measured, exact, at),
      compare<long double>(Arithmetic::extended, program, measured, exact, at),
      compare<dd_real>(Arithmetic::double_double, program, measured, exact, at),
  };
  std::vector<double> condition = condition_numbers(program, measured, at, options.operations);
  std::erase_if(condition, [](double each) { return std::isnan(each); });
  result.condition_known = condition.size();
  result.condition = spread_of(std::move(condition));
  if (options.milliseconds <= 0.0 || samples.samples() == 0) return result;
  const Samples timed = repeated(program, samples);
  for (ErrorMeasure& each : result.arithmetics)
    each.nanoseconds = time_of(program, timed, each.arithmetic, options.milliseconds, at);
  return result;
}

}  // namespace rigor
