// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/coefficient.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <string>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr std::int64_t largest_part = std::int64_t{1} << 30;  // so that products of two fit

[[nodiscard]] WordFraction reduced(std::int64_t above, std::int64_t below) {
  const std::int64_t common = std::gcd(above, below);
  if (common > 1) {
    above /= common;
    below /= common;
  }
  if (std::abs(above) > largest_part || below > largest_part)
    throw Undecidable("the numbers before products of operators become too large");
  return {above, below};
}

void add_term(Coefficient& into, const Monomial& monomial, const WordFraction& value) {
  const auto [at, is_new] = into.try_emplace(monomial, value);
  if (!is_new) at->second = at->second + value;
  if (at->second.above == 0) into.erase(at);
}

/// The product, and the sign that i² = −1 gives.
[[nodiscard]] std::pair<Monomial, bool> product(const Monomial& a, const Monomial& b) {
  std::map<std::uint32_t, int> exponents(a.begin(), a.end());
  for (const auto& [part, exponent] : b) exponents[part] += exponent;
  bool negative = false;
  if (const auto i = exponents.find(CommutingParts::imaginary); i != exponents.end()) {
    const int turns = ((i->second % 4) + 4) % 4;
    negative = turns >= 2;
    i->second = turns % 2;
  }
  std::erase_if(exponents, [](const auto& each) { return each.second == 0; });
  return {Monomial(exponents.begin(), exponents.end()), negative};
}

[[nodiscard]] WordFraction opposite(WordFraction value, bool negative) {
  return negative ? WordFraction{-value.above, value.below} : value;
}

}  // namespace

WordFraction operator+(const WordFraction& a, const WordFraction& b) {
  const std::int64_t common = std::gcd(a.below, b.below);
  return reduced(a.above * (b.below / common) + b.above * (a.below / common), a.below / common * b.below);
}

WordFraction operator*(const WordFraction& a, const WordFraction& b) {
  const WordFraction first = reduced(a.above, b.below);
  const WordFraction second = reduced(b.above, a.below);
  return reduced(first.above * second.above, first.below * second.below);
}

CommutingParts::CommutingParts(ExprTree& tree) : tree_(tree) {
  static_cast<void>(number_of(tree.add({.op = Op::imaginary_unit})));
}

std::uint32_t CommutingParts::number_of(ExprId part) {
  const auto next = static_cast<std::uint32_t>(parts_.size());
  const auto [at, is_new] = numbers_.try_emplace(dump(tree_, part), next);
  if (is_new) parts_.push_back(part);
  return at->second;
}

std::uint32_t CommutingParts::number_named(const std::string& name, bool complex) {
  const auto [at, is_new] = named_.try_emplace(name, static_cast<std::uint32_t>(parts_.size()));
  if (!is_new) return at->second;
  Symbol symbol;
  symbol.name = name;
  symbol.complex = complex;
  symbol.made_at = tree_.size();
  const SymbolId made = tree_.symbols.add(std::move(symbol));
  const ExprId part = tree_.add({.op = Op::symbol, .symbol = made});
  parts_.push_back(part);
  numbers_.emplace(dump(tree_, part), at->second);
  return at->second;
}

std::uint32_t CommutingParts::conjugate_of(std::uint32_t number) {
  const ExprId part = parts_[number];
  if (!has_complex_numbers(tree_, part)) return number;
  if (tree_[part].op == Op::conjugate) return number_of(tree_.children(part)[0]);
  return number_of(tree_.add({.op = Op::conjugate, .span = tree_[part].span}, std::span(&part, 1)));
}

Coefficient rational(WordFraction value) {
  return value.above == 0 ? Coefficient{} : Coefficient{{Monomial{}, value}};
}

Coefficient power_of_part(std::uint32_t number, int exponent) {
  const auto [monomial, negative] = product({}, {{number, exponent}});
  return {{monomial, WordFraction{negative ? -1 : 1, 1}}};
}

void add_to(Coefficient& into, const Coefficient& more) {
  for (const auto& [monomial, value] : more) add_term(into, monomial, value);
}

Coefficient times(const Coefficient& a, const Coefficient& b) {
  constexpr std::size_t most_terms = 2'000;
  Coefficient result;
  for (const auto& [first, value] : a) {
    for (const auto& [second, other] : b) {
      const auto [monomial, negative] = product(first, second);
      add_term(result, monomial, opposite(value * other, negative));
    }
    if (result.size() > most_terms)
      throw Undecidable("the coefficients of products of operators become too long");
  }
  return result;
}

Coefficient inverse(const Coefficient& a, bool always) {
  if (a.size() != 1) return {};
  const auto& [monomial, value] = *a.begin();
  Monomial turned = monomial;
  for (auto& [part, exponent] : turned) {
    if (always && exponent > 0 && part != CommutingParts::imaginary) return {};
    exponent = -exponent;
  }
  const auto [reciprocal, negative] = product({}, turned);
  const WordFraction inverted =
      value.above < 0 ? WordFraction{-value.below, -value.above} : WordFraction{value.below, value.above};
  return {{reciprocal, opposite(inverted, negative)}};
}

Coefficient conjugate(const Coefficient& a, CommutingParts& parts) {
  Coefficient result;
  for (const auto& [monomial, value] : a) {
    std::map<std::uint32_t, int> exponents;
    bool negative = false;
    for (const auto& [part, exponent] : monomial) {
      if (part == CommutingParts::imaginary) negative = true;
      exponents[part == CommutingParts::imaginary ? part : parts.conjugate_of(part)] += exponent;
    }
    add_term(result, Monomial(exponents.begin(), exponents.end()), opposite(value, negative));
  }
  return result;
}

namespace {

using Value = std::complex<double>;

/// Nothing where something else than a root or a rational function of letters is met. Recursion: as deep as
/// the tree.
std::optional<Value> value_of(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  std::vector<Value> values;
  if (node.op == Op::symbol && node.slot_count == 0)
    return 0.5 + std::fmod(0.618034 * static_cast<double>(static_cast<std::size_t>(node.symbol) + 1), 1.0);
  if (node.op == Op::number) return std::strtod(tree.digits(id).c_str(), nullptr);
  if (node.op == Op::imaginary_unit) return Value(0.0, 1.0);
  for (const ExprId child : tree.children(id)) {
    const auto value = value_of(tree, child);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  switch (node.op) {
    case Op::add:
      return std::accumulate(values.begin(), values.end(), Value(0.0));
    case Op::multiply:
      return std::accumulate(values.begin(), values.end(), Value(1.0), std::multiplies<>());
    case Op::negate:
      return -values[0];
    case Op::divide:
      return values[0] / values[1];
    case Op::power:
      return std::pow(values[0], node.exponent);
    case Op::root:
      return std::sqrt(values[0]);
    default:
      return std::nullopt;
  }
}

}  // namespace

bool is_nearly_zero(const Coefficient& a, const CommutingParts& parts) {
  constexpr double rounding = 1e-9;
  Value sum = 0.0;
  double size = 0.0;
  for (const auto& [monomial, factor] : a) {
    Value term = static_cast<double>(factor.above) / static_cast<double>(factor.below);
    for (const auto& [number, exponent] : monomial) {
      const auto value = value_of(parts.tree(), parts.part(number));
      if (!value) return false;
      term *= std::pow(*value, exponent);
    }
    sum += term;
    size += std::abs(term);
  }
  return std::isfinite(size) && std::abs(sum) <= rounding * size;
}

ExprId as_expression(const Coefficient& a, CommutingParts& parts, Span span) {
  ExprTree& tree = parts.tree();
  std::vector<ExprId> terms;
  for (const auto& [monomial, value] : a) {
    std::vector<ExprId> factors{tree.add_number(span, std::to_string(std::abs(value.above)))};
    if (value.below != 1) {
      const ExprId quotient[] = {factors[0], tree.add_number(span, std::to_string(value.below))};
      factors[0] = tree.add({.op = Op::divide, .span = span}, quotient);
    }
    for (const auto& [number, exponent] : monomial) {
      const ExprId part = parts.part(number);
      factors.push_back(exponent == 1 ? part
                                      : tree.add({.op = Op::power, .span = span, .exponent = exponent},
                                                 std::span(&part, 1)));
    }
    const ExprId whole =
        factors.size() == 1 ? factors[0] : tree.add({.op = Op::multiply, .span = span}, factors);
    terms.push_back(value.above < 0 ? tree.add({.op = Op::negate, .span = span}, std::span(&whole, 1))
                                    : whole);
  }
  if (terms.empty()) return tree.add_number(span, "0");
  return terms.size() == 1 ? terms[0] : tree.add({.op = Op::add, .span = span}, terms);
}

}  // namespace rigor
