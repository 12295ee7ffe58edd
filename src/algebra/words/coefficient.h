// SPDX-License-Identifier: GPL-3.0-or-later
// What stands before a product of operators: a sum of rational multiples of products of commuting parts.
// These parts are opaque here; whether a coefficient is 0 in the end is asked of the engine for numbers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// In lowest terms, the denominator positive.
struct WordFraction {
  std::int64_t above = 0;
  std::int64_t below = 1;
  friend bool operator==(const WordFraction&, const WordFraction&) = default;
};
/// Throws Undecidable where numbers grow too large.
[[nodiscard]] WordFraction operator+(const WordFraction& a, const WordFraction& b);
[[nodiscard]] WordFraction operator*(const WordFraction& a, const WordFraction& b);

/// The commuting parts by number, each once. i is the first.
class CommutingParts {
 public:
  explicit CommutingParts(ExprTree& tree);

  [[nodiscard]] std::uint32_t number_of(ExprId part);
  /// Of a number that has this name here alone, such as a trace.
  [[nodiscard]] std::uint32_t number_named(const std::string& name, bool complex = false);
  [[nodiscard]] ExprId part(std::uint32_t number) const { return parts_[number]; }
  /// The number of the complex conjugate; of a real part its own.
  [[nodiscard]] std::uint32_t conjugate_of(std::uint32_t number);
  [[nodiscard]] ExprTree& tree() { return tree_; }
  [[nodiscard]] const ExprTree& tree() const { return tree_; }

  static constexpr std::uint32_t imaginary = 0;

 private:
  ExprTree& tree_;
  std::vector<ExprId> parts_;
  std::unordered_map<std::string, std::uint32_t> numbers_;  // by dump
  std::unordered_map<std::string, std::uint32_t> named_;
};

/// Numbers of parts with their exponents, which are not 0, by ascending number.
using Monomial = std::vector<std::pair<std::uint32_t, int>>;
/// No term is 0; i has the exponent 1 or none.
using Coefficient = std::map<Monomial, WordFraction>;

[[nodiscard]] Coefficient rational(WordFraction value);
[[nodiscard]] Coefficient power_of_part(std::uint32_t number, int exponent);
void add_to(Coefficient& into, const Coefficient& more);
[[nodiscard]] Coefficient times(const Coefficient& a, const Coefficient& b);
/// 1/a of one term. `always`: only where it is surely not 0, which is so for rational multiples of i and of
/// what stands in a denominator already. Empty: it is not known.
[[nodiscard]] Coefficient inverse(const Coefficient& a, bool always);
[[nodiscard]] Coefficient conjugate(const Coefficient& a, CommutingParts& parts);
/// Is it near 0 where its letters have some positive values? What is not is not 0; what is may be: the parts
/// of
/// `\sqrt{a/b}\sqrt{b/a} - 1` depend on each other.
[[nodiscard]] bool is_nearly_zero(const Coefficient& a, const CommutingParts& parts);
[[nodiscard]] ExprId as_expression(const Coefficient& a, CommutingParts& parts, Span span);

}  // namespace rigor
