// SPDX-License-Identifier: GPL-3.0-or-later
// An exact rational number that is a machine word while it is whole and fits, and CLN's otherwise. Nearly all
// coefficients of the notes' polynomials are small and whole, and CLN calls a function for each sum of two.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

#include <cstdint>

#include "algebra/engine/exact_number.h"

namespace rigor {

class PackedNumber {
 public:
  PackedNumber(std::int64_t value = 0) : small_(value) {}
  PackedNumber(const Rational& value) { set(value); }

  [[nodiscard]] bool is_zero() const { return small_ == 0 && is_small(); }
  [[nodiscard]] bool is_one() const { return small_ == 1; }
  /// Whole, and fits into a word?
  [[nodiscard]] bool is_small() const { return cln::zerop(large_); }
  [[nodiscard]] std::int64_t small() const { return small_; }
  [[nodiscard]] Rational exact() const { return is_small() ? Rational(cln::cl_I(long{small_})) : large_; }

  PackedNumber& operator+=(const PackedNumber& other) {
    std::int64_t sum = 0;
    if (is_small() && other.is_small() && !__builtin_add_overflow(small_, other.small_, &sum)) {
      small_ = sum;
    } else {
      set(exact() + other.exact());
    }
    return *this;
  }
  friend PackedNumber operator*(const PackedNumber& a, const PackedNumber& b) {
    std::int64_t product = 0;
    if (a.is_small() && b.is_small() && !__builtin_mul_overflow(a.small_, b.small_, &product)) return product;
    return a.exact() * b.exact();
  }
  /// The divisor is not 0.
  friend PackedNumber operator/(const PackedNumber& a, const PackedNumber& b) {
    if (b.is_one()) return a;
    // The lowest number has no opposite.
    const bool whole = a.is_small() && b.is_small() && b.small_ != -1 && a.small_ % b.small_ == 0;
    return whole ? PackedNumber(a.small_ / b.small_) : PackedNumber(a.exact() / b.exact());
  }
  friend PackedNumber operator-(const PackedNumber& a) { return a * PackedNumber(-1); }
  friend bool operator==(const PackedNumber& a, const PackedNumber& b) {
    return a.small_ == b.small_ && cln::equal(a.large_, b.large_);
  }

 private:
  void set(const Rational& value) {
    constexpr std::uintptr_t bits = 63;
    const cln::cl_I above = cln::numerator(value);
    const bool fits = cln::denominator(value) == 1 && cln::integer_length(above) <= bits;
    small_ = fits ? cln::cl_I_to_long(above) : 0;
    large_ = fits ? Rational(0) : value;
  }

  std::int64_t small_ = 0;
  Rational large_ = 0;  // not 0 where the number does not fit into the word, which is then 0
};

}  // namespace rigor
