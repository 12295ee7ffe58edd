// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/reference.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "numeric/measure/measure.h"
#include "numeric/measure/reference_exact.h"
#include "numeric/program/code.h"
#include "numeric/run/run_bounded_decimal.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {
namespace {

constexpr int known_bits = 133;  // 40 decimal digits
// Operations with so many digits; samples beyond stay unknown.
constexpr std::size_t operations_with_400 = 400'000;
constexpr std::size_t operations_with_1400 = 40'000;
constexpr std::size_t operations_of_a_function = 100;  // a sine with so many digits takes as long

template <unsigned digits>
[[nodiscard]] Known settled(const BoundedDecimal<digits>& result) {
  if (result.undefined) return Known::undefined;
  if (result.is_exact_zero()) return Known::zero;
  return result.is_known_to(known_bits) ? Known::value : Known::unknown;
}

[[nodiscard]] std::size_t functions_of(const Code& code) {
  return static_cast<std::size_t>(std::ranges::count_if(code.values, [](const Value& value) {
    return value.op >= Instruction::sin && value.op <= Instruction::tanh;
  }));
}

/// The results of all samples, and the samples with an unknown result.
class Settlement {
 public:
  Settlement(const Program& program, const Samples& samples, std::span<const std::uint32_t> at)
      : program_(program), samples_(samples), at_(at) {
    const std::size_t count = program.outputs() * samples.samples();
    digits_.values.resize(count);
    digits_.known.resize(count, Known::unknown);
    for (std::size_t i = 0; i < samples.samples(); ++i) doubtful_.push_back(i);
  }

  template <unsigned digits>
  void run(std::size_t operations = std::numeric_limits<std::size_t>::max()) {
    const std::vector<std::size_t> which = affordable(operations);
    if (which.empty()) return;
    const Samples chosen = samples_.only(which);
    const auto results = run_on_samples<BoundedDecimal<digits>>(program_, chosen, Lanes::none, at_);
    take(
        which, [&](std::size_t at) { return ReferenceNumber(results[at].value); },
        [&](std::size_t at) { return settled(results[at]); });
  }

  void run_exactly() {
    if (doubtful_.empty()) return;
    const std::vector<std::size_t> which = doubtful_;
    const ReferenceDigits exact = exact_results(program_, samples_.only(which), at_);
    take(
        which, [&](std::size_t at) { return exact.values[at]; },
        [&](std::size_t at) { return exact.known[at]; });
  }

  [[nodiscard]] ReferenceDigits digits() { return std::move(digits_); }

 private:
  [[nodiscard]] std::vector<std::size_t> affordable(std::size_t operations) const {
    std::vector<std::size_t> which = doubtful_;
    const std::size_t work =
        work_of(program_, samples_) + operations_of_a_function * functions_of(program_.code());
    if (operations / work < which.size()) which.resize(operations / work);
    return which;
  }

  template <class ValueOf, class KnownOf>
  void take(const std::vector<std::size_t>& which, const ValueOf& value_of, const KnownOf& known_of) {
    for (std::size_t output = 0; output < program_.outputs(); ++output) {
      for (std::size_t k = 0; k < which.size(); ++k) {
        const std::size_t from = output * which.size() + k;
        const std::size_t to = output * samples_.samples() + which[k];
        if (digits_.known[to] != Known::unknown) continue;
        digits_.known[to] = known_of(from);
        if (digits_.known[to] == Known::value) digits_.values[to] = value_of(from);
      }
    }
    std::erase_if(doubtful_, [&](std::size_t sample) {
      for (std::size_t output = 0; output < program_.outputs(); ++output)
        if (digits_.known[output * samples_.samples() + sample] == Known::unknown) return false;
      return true;
    });
  }

  const Program& program_;
  const Samples& samples_;
  std::span<const std::uint32_t> at_;
  ReferenceDigits digits_;
  std::vector<std::size_t> doubtful_;
};

}  // namespace

ReferenceDigits reference_digits(const Program& program, const Samples& samples,
                                 std::span<const std::uint32_t> at) {
  Settlement settlement(program, samples, at);
  settlement.run<100>();
  settlement.run_exactly();
  settlement.run<400>(operations_with_400);
  settlement.run<1400>(operations_with_1400);
  return settlement.digits();
}

}  // namespace rigor
