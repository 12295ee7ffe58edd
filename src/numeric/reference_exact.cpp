// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/reference_exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <stdexcept>

#include "numeric/run_samples_parts.h"

namespace rigor {
namespace {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
constexpr std::size_t most_operations = 100'000;

}  // namespace

template <>
struct NumberTraits<Rational> {
  static constexpr bool has_lanes = false;
  static Rational absolute(const Rational& x) { return abs(x); }
  static Rational root(const Rational&) { throw std::domain_error("no rational root"); }
  static Rational sine(const Rational& x) { return root(x); }
  static Rational cosine(const Rational& x) { return root(x); }
  static Rational exponential(const Rational& x) { return root(x); }
  static Rational read(const std::string& digits) {
    const std::size_t point = digits.find('.');
    if (point == std::string::npos) return Rational(digits);
    std::string whole = digits;
    whole.erase(point, 1);
    whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));  // 0 first would mean octal
    return Rational(whole + "/1" + std::string(digits.size() - point - 1, '0'));
  }
};

std::optional<std::vector<ReferenceNumber>> exact_results(const Program& program, const Samples& samples,
                                                          std::span<const std::uint32_t> at) {
  const auto lacks_rational = [](const Value& value) {
    return value.op == Instruction::root || (value.op >= Instruction::sin && value.op <= Instruction::exp);
  };
  const std::vector<Value>& values = program.code().values;
  if (std::any_of(values.begin(), values.end(), lacks_rational)) return std::nullopt;
  const ProgramCounts counts = program.counts();
  if ((counts.once + counts.per_particle * samples.particles()) * samples.samples() > most_operations)
    return std::nullopt;
  for (const ProgramInput& input : program.inputs()) {
    const std::span<const double> column = samples.find(input.symbol, input.component)->values;
    if (!std::all_of(column.begin(), column.end(), [](double value) { return std::isfinite(value); }))
      return std::nullopt;
  }
  try {
    std::vector<ReferenceNumber> results;
    for (const Rational& value : run_on_samples<Rational>(program, samples, Lanes::none, at))
      results.push_back(ReferenceNumber(numerator(value)) / ReferenceNumber(denominator(value)));
    return results;
  } catch (const std::exception&) {  // divides by 0
    return std::nullopt;
  }
}

}  // namespace rigor
