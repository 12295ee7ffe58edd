// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/reference_exact.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <stdexcept>

#include "numeric/measure/measure.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

// In products of two words of an integer: a greatest common divisor takes about as many as words squared.
constexpr std::size_t most_work = 16'000'000;
constexpr std::size_t most_work_for_a_sample = 1'000'000;

struct NotRational : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the running sample may still cost. Numbers have no other way to know of each other.
thread_local std::size_t left = 0;

[[nodiscard]] std::size_t words_of(const Rational& x) {
  return numerator(x).backend().size() + denominator(x).backend().size();
}

/// Before an operation.
void spend(const Rational& x, const Rational& y) {
  const std::size_t words = words_of(x) + words_of(y);
  const std::size_t work = words * words;
  if (work > left) throw NotRational("takes too long");
  left -= work;
}

struct ExactNumber {
  Rational value = 0;
  bool undefined = false;

  ExactNumber() = default;
  explicit ExactNumber(double x) : undefined(!std::isfinite(x)) {
    if (!undefined) value = x;
  }
  [[nodiscard]] static ExactNumber with_digits(const LongNumber& number) {
    if (number.error != 0) throw NotRational("known to some digits only");
    Rational above = 0;
    Rational below = 0;
    for (const double part : number.parts) above += Rational(part);
    for (const double part : number.divisor) below += Rational(part);
    return {Rational(above / below), false};
  }
  ExactNumber(Rational result, bool none) : value(std::move(result)), undefined(none) {}
};

[[nodiscard]] ExactNumber operator-(const ExactNumber& x) { return {Rational(-x.value), x.undefined}; }
[[nodiscard]] ExactNumber operator+(const ExactNumber& x, const ExactNumber& y) {
  spend(x.value, y.value);
  return {Rational(x.value + y.value), x.undefined || y.undefined};
}
[[nodiscard]] ExactNumber operator-(const ExactNumber& x, const ExactNumber& y) {
  spend(x.value, y.value);
  return {Rational(x.value - y.value), x.undefined || y.undefined};
}
[[nodiscard]] ExactNumber operator*(const ExactNumber& x, const ExactNumber& y) {
  spend(x.value, y.value);
  return {Rational(x.value * y.value), x.undefined || y.undefined};
}
[[nodiscard]] ExactNumber operator/(const ExactNumber& x, const ExactNumber& y) {
  if (x.undefined || y.undefined || y.value == 0) return {Rational(0), true};
  spend(x.value, y.value);
  return {Rational(x.value / y.value), false};
}

[[nodiscard]] Integer root_of(const Integer& x) {
  Integer rest;
  Integer result = sqrt(x, rest);
  if (rest != 0) throw NotRational("no rational root");
  return result;
}

/// The value at 0, the only argument with a rational one.
[[nodiscard]] ExactNumber at_zero(const ExactNumber& x, int value) {
  if (!x.undefined && x.value != 0) throw NotRational("no rational value");
  return {Rational(value), x.undefined};
}

/// How many numbers are read for one sample, whether they are used or not.
[[nodiscard]] std::size_t inputs_of(const Program& program, const Samples& samples) {
  std::size_t count = 1;
  for (const ProgramInput& input : program.inputs())
    count += samples.find(input.symbol, input.component)->particle_stride == 0 ? 1 : samples.particles();
  return count;
}

/// Every operation on numbers of a word each; with inputs.
[[nodiscard]] std::size_t least_work(const Program& program, const Samples& samples) {
  const std::size_t operations = work_of(program, samples);
  if (operations > most_work_for_a_sample) return operations;
  return 4 * operations + inputs_of(program, samples);
}

}  // namespace

template <>
struct NumberTraits<ExactNumber> {
  static constexpr bool has_lanes = false;
  static ExactNumber absolute(const ExactNumber& x) { return x.value < 0 ? -x : x; }
  static ExactNumber root(const ExactNumber& x) {
    if (x.undefined || x.value < 0) return {Rational(0), true};
    spend(x.value, x.value);
    return {Rational(root_of(numerator(x.value)), root_of(denominator(x.value))), false};
  }
  static ExactNumber sine(const ExactNumber& x) { return at_zero(x, 0); }
  static ExactNumber cosine(const ExactNumber& x) { return at_zero(x, 1); }
  static ExactNumber exponential(const ExactNumber& x) { return at_zero(x, 1); }
  static ExactNumber tangent(const ExactNumber& x) { return at_zero(x, 0); }
  static ExactNumber hyperbolic_sine(const ExactNumber& x) { return at_zero(x, 0); }
  static ExactNumber hyperbolic_cosine(const ExactNumber& x) { return at_zero(x, 1); }
  static ExactNumber hyperbolic_tangent(const ExactNumber& x) { return at_zero(x, 0); }
  static ExactNumber read(const std::string& digits) {
    const std::size_t point = digits.find('.');
    if (point == std::string::npos) return {Rational(digits), false};
    std::string whole = digits;
    whole.erase(point, 1);
    whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));  // 0 first would mean octal
    return {Rational(whole + "/1" + std::string(digits.size() - point - 1, '0')), false};
  }
};

ReferenceDigits exact_results(const Program& program, const Samples& samples,
                              std::span<const std::uint32_t> at) {
  const std::size_t count = program.outputs() * samples.samples();
  ReferenceDigits exact{std::vector<ReferenceNumber>(count), std::vector<Known>(count, Known::unknown)};
  const std::size_t least = least_work(program, samples);
  std::size_t total = most_work;
  for (std::size_t sample = 0; sample < samples.samples(); ++sample) {
    const std::size_t given = std::min(total, most_work_for_a_sample);
    if (given < least) break;
    left = given - inputs_of(program, samples);
    try {
      const auto results =
          run_on_samples<ExactNumber>(program, samples.only(std::array{sample}), Lanes::none, at);
      for (std::size_t output = 0; output < results.size(); ++output) {
        const ExactNumber& result = results[output];
        const std::size_t to = output * samples.samples() + sample;
        exact.known[to] = result.undefined    ? Known::undefined
                          : result.value == 0 ? Known::zero
                                              : Known::value;
        if (exact.known[to] == Known::value)
          exact.values[to] =
              ReferenceNumber(numerator(result.value)) / ReferenceNumber(denominator(result.value));
      }
    } catch (const NotRational&) {
    }
    total -= given - left;
  }
  return exact;
}

}  // namespace rigor
