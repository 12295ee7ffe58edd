// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial as a sorted list of terms: the exponents of a monomial are bytes, eight to a machine word, so
// that monomials are multiplied by adding words and compared word by word. Variables are numbers; what they
// stand for, `PackedLetters` knows. The order of terms is that of the variables' numbers, the same in every
// run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algebra/packed/packed_number.h"

namespace rigor {

class PackedPolynomial {
 public:
  static constexpr int largest_degree = 255;  // of all variables together

  PackedPolynomial() = default;  // 0
  PackedPolynomial(const PackedNumber& number);
  PackedPolynomial(int number) : PackedPolynomial(PackedNumber(number)) {}
  /// number · x^exponent …, for different variables; the exponents' sum is at most `largest_degree`.
  PackedPolynomial(const PackedNumber& number,
                   std::span<const std::pair<std::size_t, int>> powers_of_variables);

  /// The sum of terms that are written one after the other: each has a number, and ends after so many powers.
  struct Terms {
    std::vector<PackedNumber> numbers = {};
    std::vector<std::size_t> ends = {};
    std::vector<std::pair<std::size_t, int>> powers = {};
  };
  explicit PackedPolynomial(Terms terms);

  /// How many terms.
  [[nodiscard]] std::size_t size() const { return coefficients_.size(); }
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  [[nodiscard]] bool is_number() const { return is_zero() || (size() == 1 && is_constant(0)); }
  /// Is a term without variables?
  [[nodiscard]] bool is_constant(std::size_t term) const;
  [[nodiscard]] const PackedNumber& coefficient(std::size_t term) const { return coefficients_[term]; }
  /// The variables of a term from the lowest number on, with their exponents: visit(variable, exponent).
  template <class Visit>
  void for_each_power(std::size_t term, const Visit& visit) const {
    for (std::size_t w = 0; w < words_; ++w) {
      std::size_t variable = w * exponents_in_word;
      for (std::uint64_t word = monomial(term)[w]; word != 0; word >>= exponent_bits, ++variable) {
        if (const auto exponent = static_cast<int>(word & exponent_mask); exponent > 0)
          visit(variable, exponent);
      }
    }
  }
  /// The exponent of a variable in a term.
  [[nodiscard]] int exponent(std::size_t term, std::size_t variable) const {
    const std::size_t word = variable / exponents_in_word;
    if (word >= words_) return 0;
    const std::size_t shift = variable % exponents_in_word * exponent_bits;
    return static_cast<int>(monomial(term)[word] >> shift & exponent_mask);
  }
  /// The highest exponent of a variable.
  [[nodiscard]] int degree_in(std::size_t variable) const;
  /// The same of the variables below a number.
  [[nodiscard]] std::vector<int> degrees(std::size_t variables) const;
  /// The sum of the terms with variable^exponent, without that.
  [[nodiscard]] PackedPolynomial coefficient_of(std::size_t variable, int exponent) const;
  /// At least the highest total degree of a term: cancellation does not lower it.
  [[nodiscard]] int degree_bound() const { return degree_; }

  /// The sum of all: one sort of all their terms.
  [[nodiscard]] static PackedPolynomial sum(std::span<const PackedPolynomial* const> summands);
  friend PackedPolynomial operator+(const PackedPolynomial& a, const PackedPolynomial& b);
  /// The degrees' sum must be at most `largest_degree`.
  friend PackedPolynomial operator*(const PackedPolynomial& a, const PackedPolynomial& b);
  friend PackedPolynomial operator-(PackedPolynomial a);
  friend PackedPolynomial operator-(const PackedPolynomial& a, PackedPolynomial b) {
    return a + -std::move(b);
  }
  /// value / divisor, if that is a polynomial; the divisor is not 0.
  friend std::optional<PackedPolynomial> exact_quotient(PackedPolynomial value, PackedPolynomial divisor);
  friend bool operator==(const PackedPolynomial& a, const PackedPolynomial& b);
  /// The exponent is positive.
  friend PackedPolynomial power(const PackedPolynomial& base, int exponent);

 private:
  static constexpr int exponent_bits = 8;
  static constexpr std::uint64_t exponent_mask = (1U << exponent_bits) - 1;
  static constexpr std::size_t exponents_in_word = 64 / exponent_bits;

  [[nodiscard]] const std::uint64_t* monomial(std::size_t term) const {
    return exponents_.data() + term * words_;
  }
  [[nodiscard]] PackedPolynomial less(std::size_t count, std::span<const std::uint64_t> monomial,
                                      const PackedNumber& coefficient, const PackedPolynomial& divisor) const;
  void push(std::span<const std::uint64_t> monomial, PackedNumber coefficient);
  void widen(std::size_t words);
  void reverse();
  void append(const PackedPolynomial& more);  // has at most as many words
  void append(const PackedPolynomial& from, std::size_t term);
  void combine();

  std::size_t words_ = 0;  // of each monomial
  int degree_ = 0;
  std::vector<std::uint64_t> exponents_;  // of one term after the other
  std::vector<PackedNumber> coefficients_;
};

}  // namespace rigor
