// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/exact_number.h"

#include <cln/integer.h>
#include <cln/integer_io.h>

#include <algorithm>
#include <sstream>

namespace rigor {
namespace {

constexpr std::size_t longest_text = 4'000;  // signs of a number that is read: ours have 200 digits at most

[[nodiscard]] bool is_natural(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

[[nodiscard]] cln::cl_I natural(std::string_view digits) {
  return digits.empty() ? cln::cl_I(0) : cln::cl_I(std::string(digits).c_str());
}

[[nodiscard]] std::string natural_text(const cln::cl_I& value) {
  std::ostringstream out;
  cln::fprintdecimal(out, value);
  return out.str();
}

}  // namespace

Rational from_digits(const std::string& digits) {
  const std::size_t point = digits.find('.');
  if (point == std::string::npos) return natural(digits);
  const std::string decimals = digits.substr(point + 1);
  const Rational scale = power_of(10, static_cast<int>(decimals.size()));
  return Rational(natural(digits.substr(0, point) + decimals)) / scale;
}

std::optional<Rational> from_text(std::string_view text) {
  if (text.size() > longest_text) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  const std::string_view above = text.substr(0, slash);
  const std::string_view below = slash == std::string_view::npos ? "1" : text.substr(slash + 1);
  if (!is_natural(above) || !is_natural(below)) return std::nullopt;
  const cln::cl_I denominator = natural(below);
  if (cln::zerop(denominator)) return std::nullopt;
  const Rational value = Rational(natural(above)) / denominator;
  return negative ? -value : value;
}

std::string to_text(const Rational& value) {
  const cln::cl_I denominator = cln::denominator(value);
  std::string text = cln::minusp(value) ? "-" : "";
  text += natural_text(cln::abs(cln::numerator(value)));
  if (denominator != 1) text += '/' + natural_text(denominator);
  return text;
}

std::optional<Rational> exact_root(const Rational& value) {
  if (cln::minusp(value)) return std::nullopt;
  Rational root;
  if (!cln::sqrtp(value, &root)) return std::nullopt;
  return root;
}

double bit_size(const Rational& value) {
  return static_cast<double>(cln::integer_length(cln::numerator(value))) +
         static_cast<double>(cln::integer_length(cln::denominator(value) - 1));
}

bool is_related(const Rational& left, Relation relation, const Rational& right) {
  switch (relation) {
    case Relation::equal:
      return left == right;
    case Relation::less:
      return left < right;
    case Relation::less_or_equal:
      return left <= right;
    case Relation::unequal:
      return left != right;
  }
  return false;
}

Rational power_of(const Rational& base, int exponent) { return cln::expt(base, exponent); }

}  // namespace rigor
