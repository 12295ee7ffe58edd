// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/expected_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/measure/measure.h"

namespace rigor {
namespace {

constexpr long double beyond_first_order = 16;     // so far apart, something overflowed
constexpr long double half_of_least = 0x1p-1075L;  // what is rounded off below the normal range

bool is_power_of_two(const Code& code, ValueId id) {
  const Value& value = code.values[id];
  if (value.op != Instruction::constant || !code.constants[value.a].digits.empty()) return false;
  int exponent = 0;
  return std::frexp(code.constants[value.a].value, &exponent) == 0.5;
}

/// Does it never round, but below the normal range? Inputs are exact; so are constants that double has.
bool never_rounds(const Code& code, const Value& value) {
  switch (value.op) {
    case Instruction::constant:
      return code.constants[value.a].digits.empty();
    case Instruction::input:
    case Instruction::negate:
    case Instruction::absolute:
      return true;
    case Instruction::multiply:
      return is_power_of_two(code, value.a) || is_power_of_two(code, value.b);
    case Instruction::divide:
      return is_power_of_two(code, value.b);
    default:
      return false;
  }
}

/// What a rounded sum leaves out (Knuth's TwoSum).
long double two_sum_error(long double a, long double b, long double sum) {
  const long double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b);
}

}  // namespace

ErrorTape::ErrorTape(const Code& code)
    : code_(code), rounded_(code), wide_(code), adjoint_(code.values.size()) {
  for (const Value& value : code.values) exact_.push_back(never_rounds(code, value));
}

ExpectedError ErrorTape::at(std::span<const double> inputs) {
  rounded_.run(inputs);
  wide_.run(inputs);
  ExpectedError error{.relative = 1, .size = 0, .has_value = true};
  long double apart = 0;  // of double from long double
  bool is_finite = true;
  for (const ValueId output : code_.outputs) {
    const long double value = wide_[output];
    if (!std::isfinite(value)) error.has_value = false;
    error.size = std::max(error.size, std::abs(value));
    if (!std::isfinite(rounded_[output])) is_finite = false;
    apart = std::max(apart, std::abs(value - static_cast<long double>(rounded_[output])));
  }
  if (!error.has_value) error.outside = is_outside();
  if (!error.has_value || !is_finite || error.size == 0) return error;
  long double amount = 0;
  for (const ValueId output : code_.outputs) amount = std::max(amount, moved(output));
  if (apart > beyond_first_order * amount) amount = apart;
  const long double relative = amount / std::max(error.size, least_normal);
  if (relative < 1)  // not where it is not a number
    error.relative = std::max(unit_roundoff, static_cast<double>(relative));
  return error;
}

double ErrorTape::seen(const ErrorTape& value) const {
  long double size = 0;
  long double apart = 0;
  for (std::size_t k = 0; k < code_.outputs.size(); ++k) {
    const long double exact = value.wide_[value.code_.outputs[k]];
    const long double here = rounded_[code_.outputs[k]];
    if (!std::isfinite(here) || !std::isfinite(exact)) return std::numeric_limits<double>::infinity();
    size = std::max(size, std::abs(exact));
    apart = std::max(apart, std::abs(here - exact));
  }
  return static_cast<double>(apart / std::max(size, least_normal));
}

/// By how much all roundings together move one component.
long double ErrorTape::moved(ValueId output) {
  std::ranges::fill(adjoint_, 0.0L);
  adjoint_[output] = 1;
  long double squares = 0;
  for (ValueId id = output + 1; id-- > 0;) {
    if (adjoint_[id] == 0) continue;
    const long double by_this = adjoint_[id] * own_rounding(id);
    squares += by_this * by_this;
    if (has_operands(code_.values[id].op)) pass_on(id);
  }
  return std::isfinite(squares) ? std::sqrt(squares) : std::numeric_limits<long double>::infinity();
}

/// Does long double hold the very result of one operation on its operands as they are there?
bool ErrorTape::keeps_all(const Value& value, long double result) const {
  if (value.op == Instruction::constant) return code_.constants[value.a].digits.empty();
  if (!has_operands(value.op)) return value.op == Instruction::input;
  const long double a = wide_[value.a];
  switch (value.op) {
    case Instruction::add:
      return two_sum_error(a, wide_[value.b], result) == 0;
    case Instruction::subtract:
      return two_sum_error(a, -wide_[value.b], result) == 0;
    case Instruction::multiply:
      return std::fma(a, wide_[value.b], -result) == 0;
    case Instruction::divide:
      return std::fma(result, wide_[value.b], -a) == 0;
    case Instruction::root:
      return std::fma(result, result, -a) == 0;
    case Instruction::negate:
    case Instruction::absolute:
      return true;
    default:
      return a == 0;  // the values of all functions at 0 are 0 or 1
  }
}

/// The values that long double knows exactly, as nothing has been rounded on the way to them.
std::vector<bool> ErrorTape::unrounded() const {
  std::vector<bool> known;
  for (ValueId id = 0; id < code_.values.size(); ++id) {
    const Value& value = code_.values[id];
    const bool has_second = value.op >= Instruction::add && value.op <= Instruction::divide;
    const bool from_known = !has_operands(value.op) || (known[value.a] && (!has_second || known[value.b]));
    known.push_back(from_known && keeps_all(value, wide_[id]));
  }
  return known;
}

/// Is something negative under a root, and more so than rounding alone could make it, or is a divisor 0, and
/// not by rounding?
bool ErrorTape::is_outside() const {
  const std::vector<bool> known = unrounded();
  for (const Value& value : code_.values) {
    if (value.op == Instruction::divide && wide_[value.b] == 0 && known[value.b]) return true;
    if (value.op != Instruction::root || !(wide_[value.a] < 0)) continue;
    const Value& below = code_.values[value.a];
    const bool is_sum = below.op == Instruction::add || below.op == Instruction::subtract;
    if (!is_sum || -wide_[value.a] > 0x1p-40L * std::abs(wide_[below.a])) return true;
  }
  return false;
}

long double ErrorTape::own_rounding(ValueId id) const {
  const long double size = std::abs(wide_[id]);
  const Instruction op = code_.values[id].op;
  if (op == Instruction::input) return 0;
  if (size < least_normal) {
    const bool keeps_all = op == Instruction::add || op == Instruction::subtract || op == Instruction::negate;
    return keeps_all || size == 0 ? 0 : half_of_least;
  }
  return exact_[id] ? 0 : size * static_cast<long double>(unit_roundoff);
}

/// Adds to its operands' adjoints what comes through one value.
void ErrorTape::pass_on(ValueId id) {
  const Value& value = code_.values[id];
  const long double here = adjoint_[id];
  const long double a = wide_[value.a];
  const long double result = wide_[id];
  long double to_a = here;
  switch (value.op) {
    case Instruction::add:
      adjoint_[value.b] += here;
      break;
    case Instruction::subtract:
      adjoint_[value.b] -= here;
      break;
    case Instruction::multiply:
      adjoint_[value.b] += here * a;
      to_a = here * wide_[value.b];
      break;
    case Instruction::divide:
      adjoint_[value.b] -= here * result / wide_[value.b];
      to_a = here / wide_[value.b];
      break;
    case Instruction::negate:
      to_a = -here;
      break;
    case Instruction::root:
      to_a = here / (2 * result);
      break;
    case Instruction::absolute:
      to_a = a < 0 ? -here : here;
      break;
    case Instruction::sin:
      to_a = here * std::cos(a);
      break;
    case Instruction::cos:
      to_a = -here * std::sin(a);
      break;
    case Instruction::exp:
      to_a = here * result;
      break;
    case Instruction::tan:
      to_a = here * (1 + result * result);
      break;
    case Instruction::sinh:
      to_a = here * std::cosh(a);
      break;
    case Instruction::cosh:
      to_a = here * std::sinh(a);
      break;
    case Instruction::tanh:
      to_a = here / (std::cosh(a) * std::cosh(a));
      break;
    case Instruction::constant:
    case Instruction::input:
    case Instruction::sum:
      return;
  }
  adjoint_[value.a] += to_a;
}

}  // namespace rigor
