// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/point_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr int largest_count = 200;  // of arctan t or log t

/// How often arctan t (twice) or log t is taken; nothing where that is no whole number, or too often.
[[nodiscard]] std::optional<int> count_of(const PointValue::Part& part) {
  const Rational count = part.factor * part.meaning.multiple;
  if (cln::denominator(count) != 1 || cln::abs(count) > largest_count) return std::nullopt;
  return static_cast<int>(cln::double_approx(count));
}

[[nodiscard]] CosineAndSine turned(const CosineAndSine& a, const CosineAndSine& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

}  // namespace

const Rational& rational_of(const PointValue& value) {
  if (!is_rational(value)) throw PointRejected("a value is not rational");
  return value.rational;
}

Enclosure enclosure_of(const PointValue& value) {
  if (value.enclosed) return *value.enclosed;
  Enclosure total{value.rational, value.rational};
  for (const PointValue::Part& part : value.parts) {
    const bool angle = part.meaning.kind == Meaning::Kind::angle;
    const Rational factor = part.factor * part.meaning.multiple * (angle ? 2 : 1);
    const Enclosure of = applied(angle ? Function::arctan : Function::log, {part.number, part.number});
    total = sum(total, product({factor, factor}, of));
  }
  return total;
}

bool is_related(const PointValue& left, Relation relation, const PointValue& right) {
  PointValue difference = left;
  add(difference, scaled(right, -1));
  if (is_rational(difference)) return is_related(difference.rational, relation, Rational(0));
  const Enclosure bounds = enclosure_of(difference);
  if (cln::plusp(bounds.low)) return is_related(Rational(1), relation, Rational(0));
  if (cln::minusp(bounds.high)) return is_related(Rational(-1), relation, Rational(0));
  throw ValuesTooNear("two values that cannot be told apart");
}

void add(PointValue& total, const PointValue& summand) {
  if (total.enclosed || summand.enclosed) {
    total = PointValue(sum(enclosure_of(total), enclosure_of(summand)));
    return;
  }
  total.rational = total.rational + summand.rational;
  for (const PointValue::Part& part : summand.parts) {
    const auto at = std::ranges::lower_bound(total.parts, part.place, {}, &PointValue::Part::place);
    if (at == total.parts.end() || at->place != part.place) {
      total.parts.insert(at, part);
      continue;
    }
    at->factor = at->factor + part.factor;
    if (cln::zerop(at->factor)) total.parts.erase(at);
  }
}

PointValue scaled(PointValue value, const Rational& factor) {
  if (cln::zerop(factor)) return {};
  if (value.enclosed) return PointValue(product(*value.enclosed, {factor, factor}));
  value.rational = value.rational * factor;
  for (PointValue::Part& part : value.parts) part.factor = part.factor * factor;
  return value;
}

/// cos 2φ + i sin 2φ = (1 + i t)² / (1 + t²) for t = tan φ.
std::optional<CosineAndSine> cosine_and_sine(const PointValue& angle) {
  if (angle.enclosed || !cln::zerop(angle.rational)) return std::nullopt;
  CosineAndSine total;
  for (const PointValue::Part& part : angle.parts) {
    const auto count = part.meaning.kind == Meaning::Kind::angle ? count_of(part) : std::nullopt;
    if (!count) return std::nullopt;
    const Rational square = part.number * part.number;
    const Rational sine = 2 * part.number / (1 + square);
    const CosineAndSine once{(1 - square) / (1 + square), *count < 0 ? -sine : sine};
    for (int i = 0; i < std::abs(*count); ++i) total = turned(total, once);
  }
  return total;
}

std::optional<Rational> exponential(const PointValue& value) {
  if (value.enclosed || !cln::zerop(value.rational)) return std::nullopt;
  Rational product = 1;
  for (const PointValue::Part& part : value.parts) {
    const bool logarithm = part.meaning.kind == Meaning::Kind::logarithm && cln::plusp(part.number);
    const auto count = logarithm ? count_of(part) : std::nullopt;
    if (!count) return std::nullopt;
    product = product * power_of(part.number, *count);
  }
  return product;
}

std::string to_text(const PointValue& value) {
  return is_rational(value) ? to_text(value.rational) : to_text(enclosure_of(value));
}

std::string to_text(const Rational& number, const Meaning& meaning) {
  switch (meaning.kind) {
    case Meaning::Kind::itself:
      break;
    case Meaning::Kind::angle:
      return cln::zerop(number) ? "0" : fmt::format("{}*arctan({})", 2 * meaning.multiple, to_text(number));
    case Meaning::Kind::logarithm:
      if (number == 1) return "0";
      return meaning.multiple == 1 ? fmt::format("log({})", to_text(number))
                                   : fmt::format("{}*log({})", meaning.multiple, to_text(number));
  }
  return to_text(number);
}

std::optional<ReadNumber> read_number(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos) {
    const auto number = from_text(text);
    return number ? std::optional(ReadNumber{*number, {}}) : std::nullopt;
  }
  const auto number =
      text.ends_with(')') ? from_text(text.substr(open + 1, text.size() - open - 2)) : std::nullopt;
  std::string_view name = text.substr(0, open);
  int count = 1;
  if (const std::size_t times = name.find('*'); times != std::string_view::npos) {
    const auto [end, error] = std::from_chars(name.data(), name.data() + times, count);
    if (error != std::errc() || end != name.data() + times || count < 1) return std::nullopt;
    name.remove_prefix(times + 1);
  }
  if (!number || count > largest_count) return std::nullopt;
  if (name == "arctan" && count % 2 == 0) return ReadNumber{*number, {Meaning::Kind::angle, count / 2}};
  if (name == "log" && cln::plusp(*number)) return ReadNumber{*number, {Meaning::Kind::logarithm, count}};
  return std::nullopt;
}

}  // namespace rigor
