// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/reference.h"

#include <algorithm>

#include "numeric/reference_digits.h"
#include "numeric/reference_exact.h"
#include "numeric/run_samples_parts.h"

namespace rigor {
namespace {

constexpr const char* agreement = "1e-40";

/// The longer number is rounded to the length of the shorter one, never the other way round.
template <class Short, class Long>
[[nodiscard]] bool agree(const Short& fewer, const Long& more) {
  static const Short tolerance(agreement);
  const Short rounded(more);
  return abs(Short(fewer - rounded)) <= tolerance * abs(rounded);
}

/// Does a value fall by `digits` when so many more are computed?
template <class Short, class Long>
[[nodiscard]] bool falls(const Short& fewer, const Long& more, int digits) {
  return abs(Short(more)) <= pow(Short(10), -digits) * abs(fewer);
}

/// False: to be looked at again.
[[nodiscard]] bool settle(const Decimal<100>& with_100, const ReferenceNumber& with_200, Known& known) {
  const bool none = !boost::multiprecision::isfinite(with_100) && !boost::multiprecision::isfinite(with_200);
  known = none ? Known::undefined : Known::value;
  return none || (with_200 != 0 && agree(with_100, with_200));
}

[[nodiscard]] Known settle_again(const Decimal<100>& with_100, ReferenceNumber& value,
                                 const Decimal<400>& with_400) {
  if (!boost::multiprecision::isfinite(with_400))
    return boost::multiprecision::isfinite(value) ? Known::unknown : Known::undefined;
  if (with_400 == 0 || (falls(with_100, value, 50) && falls(value, with_400, 100))) {
    value = 0;
    return Known::zero;
  }
  const Known known = agree(value, with_400) ? Known::value : Known::unknown;
  value = ReferenceNumber(with_400);
  return known;
}

}  // namespace

ReferenceDigits reference_digits(const Program& program, const Samples& samples,
                                 std::span<const std::uint32_t> at) {
  const auto with_100 = run_on_samples<Decimal<100>>(program, samples, Lanes::none, at);
  ReferenceDigits result{run_on_samples<Decimal<200>>(program, samples, Lanes::none, at), {}};
  result.known.resize(result.values.size());
  std::vector<std::size_t> doubtful;  // samples
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    if (!settle(with_100[i], result.values[i], result.known[i])) doubtful.push_back(i % samples.samples());
  }
  if (doubtful.empty()) return result;
  std::sort(doubtful.begin(), doubtful.end());
  doubtful.erase(std::unique(doubtful.begin(), doubtful.end()), doubtful.end());
  const Samples again = samples.only(doubtful);
  const auto exact = exact_results(program, again, at);
  std::vector<Decimal<400>> with_400;
  if (!exact) with_400 = run_on_samples<Decimal<400>>(program, again, Lanes::none, at);
  for (std::size_t output = 0; output < program.outputs(); ++output) {
    for (std::size_t k = 0; k < doubtful.size(); ++k) {
      const std::size_t i = output * samples.samples() + doubtful[k];
      const std::size_t there = output * doubtful.size() + k;
      if (exact) {
        result.values[i] = (*exact)[there];
        result.known[i] = result.values[i] == 0 ? Known::zero : Known::value;
      } else {
        result.known[i] = settle_again(with_100[i], result.values[i], with_400[there]);
      }
    }
  }
  return result;
}

Reference reference(const Program& program, const Samples& samples, std::span<const std::uint32_t> at) {
  const ReferenceDigits digits = reference_digits(program, samples, at);
  Reference result{{}, digits.known};
  for (const ReferenceNumber& value : digits.values) result.values.push_back(static_cast<double>(value));
  return result;
}

}  // namespace rigor
