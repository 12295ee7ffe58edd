// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/compile_values.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rigor {
namespace {

constexpr std::size_t first_table = 512;

[[nodiscard]] std::size_t hash_of(const Value& value) {
  std::uint64_t key = (static_cast<std::uint64_t>(value.a) << 32) | value.b;
  key ^= (static_cast<std::uint64_t>(value.op) * 8u + value.level) * 0x9e3779b97f4a7c15u;
  key *= 0xff51afd7ed558ccdu;
  return static_cast<std::size_t>(key ^ (key >> 32));
}

/// In every arithmetic, without rounding and far from overflow.
[[nodiscard]] bool is_exact_everywhere(double value) {
  const double size = std::abs(value);
  return static_cast<double>(static_cast<float>(value)) == value &&
         (value == 0.0 || (size > 0x1p-60 && size < 0x1p60));
}

/// A decimal that is exact in every arithmetic: 2, 0.5, 0.25. `value` is its nearest double in any case.
[[nodiscard]] bool is_exact_decimal(const std::string& digits, double& value) {
  value = std::strtod(digits.c_str(), nullptr);
  if (digits.size() > 15 || !is_exact_everywhere(value)) return false;
  std::string whole = digits;
  const std::size_t point = digits.find('.');
  if (point == std::string::npos) return true;
  whole.erase(point, 1);
  double power_of_ten = 1.0;  // at most 1e15: exact
  for (std::size_t i = point + 1; i < digits.size(); ++i) power_of_ten *= 10.0;
  return std::fma(value, power_of_ten, -std::strtod(whole.c_str(), nullptr)) == 0.0;
}

}  // namespace

ValueTable::ValueTable(Code& code) : code_(&code), slots_(first_table, 0) {
  code.values.reserve(64);
  code.constants.reserve(8);
  static_cast<void>(number({.op = Instruction::constant, .a = 0}));
  static_cast<void>(number({.op = Instruction::constant, .a = 1}));
  code.constants.push_back({{}, 0.0});
  code.constants.push_back({{}, 1.0});
}

Operand ValueTable::number(const Value& value) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash_of(value) & mask;
  for (; slots_[at] != 0; at = (at + 1) & mask) {
    const Value& known = code_->values[slots_[at] - 1];
    if (known.op == value.op && known.a == value.a && known.b == value.b && known.level == value.level)
      return 2 * (slots_[at] - 1);
  }
  Value added = value;
  if (has_operands(value.op)) {
    const Value& a = code_->values[value.a];
    added.levels = a.levels;
    added.height = a.height;
    if (has_second_operand(value.op)) {
      const Value& b = code_->values[value.b];
      added.levels = static_cast<LevelMask>(a.levels | b.levels);
      added.height = std::max(a.height, b.height);
    }
    if (value.op == Instruction::sum) {
      added.levels = static_cast<LevelMask>(a.levels & ~(1u << value.level));
      ++added.height;
    }
  }
  code_->values.push_back(added);
  slots_[at] = static_cast<std::uint32_t>(code_->values.size());
  if (2 * code_->values.size() > slots_.size()) grow();
  return static_cast<Operand>(2 * (code_->values.size() - 1));
}

void ValueTable::grow() {
  slots_.assign(2 * slots_.size(), 0);
  const std::size_t mask = slots_.size() - 1;
  for (std::uint32_t i = 0; i < code_->values.size(); ++i) {
    std::size_t at = hash_of(code_->values[i]) & mask;
    while (slots_[at] != 0) at = (at + 1) & mask;
    slots_[at] = i + 1;
  }
}

Operand ValueTable::exact_constant(double value) {
  const bool negative = std::signbit(value);
  const double size = std::abs(value);
  std::uint32_t at = 2;  // the first two are structural
  while (at < code_->constants.size() &&
         !(code_->constants[at].digits.empty() && code_->constants[at].value == size))
    ++at;
  if (at == code_->constants.size()) code_->constants.push_back({{}, size});
  return number({.op = Instruction::constant, .a = at}) | (negative ? 1u : 0u);
}

Operand ValueTable::constant(const std::string& digits) {
  double value = 0.0;
  if (is_exact_decimal(digits, value)) return exact_constant(value);
  std::uint32_t at = 2;
  while (at < code_->constants.size() && code_->constants[at].digits != digits) ++at;
  if (at == code_->constants.size())
    code_->constants.push_back({digits, std::strtod(digits.c_str(), nullptr)});
  return number({.op = Instruction::constant, .a = at});
}

Operand ValueTable::integer(int value) { return exact_constant(static_cast<double>(value)); }

const double* ValueTable::exact_value(Operand a, double& storage) const {
  const Value& value = code_->values[a >> 1];
  if (value.op != Instruction::constant || !code_->constants[value.a].digits.empty()) return nullptr;
  const double size = code_->constants[value.a].value;
  storage = (a & 1u) != 0 ? -size : size;
  return &storage;
}

Operand ValueTable::input(std::uint32_t input, std::uint32_t particle) {
  const bool in_loop = particle != InputParticle::none && particle < InputParticle::first_free;
  return number({.op = Instruction::input,
                 .levels = static_cast<LevelMask>(in_loop ? 1u << particle : 0u),
                 .a = input,
                 .b = particle});
}

Operand ValueTable::add(Operand a, Operand b) {
  if (a == zero) return b;
  if (b == zero) return a;
  double x = 0.0;
  double y = 0.0;
  if (exact_value(a, x) != nullptr && exact_value(b, y) != nullptr && is_exact_everywhere(x + y) &&
      (x + y) - x == y && (x + y) - y == x)
    return exact_constant(x + y);
  if ((a >> 1) > (b >> 1)) std::swap(a, b);
  const bool differ = ((a ^ b) & 1u) != 0;
  const Instruction op = differ ? Instruction::subtract : Instruction::add;
  return number({.op = op, .a = a >> 1, .b = b >> 1}) | (a & 1u);
}

Operand ValueTable::multiply(Operand a, Operand b) {
  if (a == zero || b == zero) return zero;
  const std::uint32_t sign = (a ^ b) & 1u;
  if ((a | 1u) == minus_one) return (b & ~1u) | sign;
  if ((b | 1u) == minus_one) return (a & ~1u) | sign;
  double x = 0.0;
  double y = 0.0;
  if (exact_value(a, x) != nullptr && exact_value(b, y) != nullptr && is_exact_everywhere(x * y))
    return exact_constant(x * y);
  if ((a >> 1) > (b >> 1)) std::swap(a, b);
  return number({.op = Instruction::multiply, .a = a >> 1, .b = b >> 1}) | sign;
}

Operand ValueTable::divide(Operand a, Operand b) {
  if (a == zero) return zero;
  double x = 0.0;
  double y = 0.0;
  if (exact_value(a, x) != nullptr && exact_value(b, y) != nullptr && y != 0.0) {
    // A quotient of 24 bits times a divisor of 24 bits is exact in double: no remainder is overlooked.
    const double quotient = x / y;
    if (is_exact_everywhere(quotient) && quotient * y == x) return exact_constant(quotient);
  }
  const std::uint32_t sign = (a ^ b) & 1u;
  return number({.op = Instruction::divide, .a = a >> 1, .b = b >> 1}) | sign;
}

Operand ValueTable::power(Operand a, int exponent) {
  if (exponent == 0) return exact_constant(1.0);
  if (exponent < 0) return divide(exact_constant(1.0), power(a, -exponent));
  if (exponent == 1) return a;
  if (exponent % 2 != 0) return multiply(power(a, exponent - 1), a);
  const Operand half = power(a, exponent / 2);
  return multiply(half, half);
}

Operand ValueTable::unary(Instruction op, Operand a) {
  if (op == Instruction::absolute || op == Instruction::cos || op == Instruction::cosh) a &= ~1u;
  if (op == Instruction::negate) return negated(a);
  return number({.op = op, .a = value_of(a)});
}

Operand ValueTable::sum(Operand a, int level) {
  if (a == zero) return zero;
  return number({.op = Instruction::sum, .level = static_cast<std::uint8_t>(level), .a = a >> 1}) | (a & 1u);
}

ValueId ValueTable::value_of(Operand a) {
  if ((a & 1u) == 0) return a >> 1;
  return number({.op = Instruction::negate, .a = a >> 1}) >> 1;
}

}  // namespace rigor
