// SPDX-License-Identifier: GPL-3.0-or-later
// A number of many decimal digits with a bound of its error, as a number of programs: the formulas of
// `bounds.h` with u = 2^(1 − bits). Differences: an error-free 0 stays one; what may be negative has no
// bounded root; what has no real value, because an error-free or bounded operand proves it, is marked. The
// library's cos (absolute) and exp (relative) are taken to be right to 2^16 u (1 + |x|); so are sin and sinh,
// and to 2^16 u |x| where |x| < 1/2.
#pragma once

#include "numeric/exact/long_number.h"
#include "numeric/run/bounds_magnitude.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

template <unsigned digits>
struct BoundedDecimal {
  using T = Decimal<digits>;
  T value = 0;
  Magnitude bound;
  bool undefined = false;  // proved

  static constexpr int bits = std::numeric_limits<T>::digits;

  BoundedDecimal() = default;
  explicit BoundedDecimal(double exact) : undefined(!std::isfinite(exact)) {
    if (!undefined) value = exact;
  }
  /// An input: high + low to within `error`.
  [[nodiscard]] static BoundedDecimal with_error(double high, double low, double error) {
    BoundedDecimal input(high);
    if (!input.undefined && low != 0) input = BoundedDecimal(T(input.value + low), Magnitude());
    if (error != 0) input.bound = input.bound + Magnitude(error);
    return input;
  }
  [[nodiscard]] static BoundedDecimal with_digits(const LongNumber& number) {
    const auto sum = [](const std::vector<double>& parts) {
      BoundedDecimal all;
      for (const double part : parts) all = all + BoundedDecimal(part);
      return all;
    };
    BoundedDecimal input = sum(number.parts) / sum(number.divisor);
    if (number.error != 0) input.bound = input.bound + Magnitude(number.error);
    return input;
  }
  /// A rounded result, with the error that its operands bring along.
  BoundedDecimal(const T& rounded, const Magnitude& carried, int lost_bits = 0) {
    if (!boost::multiprecision::isfinite(rounded)) {
      bound = Magnitude::infinite();
      return;
    }
    value = rounded;
    bound = carried + size_of(value) * Magnitude(1.0, 1 - bits + lost_bits) + least();
  }

  [[nodiscard]] static Magnitude least() { return Magnitude(1.0, std::numeric_limits<T>::min_exponent); }
  /// |x| rounded upwards, from the two leading words of its significand.
  [[nodiscard]] static Magnitude size_of(const T& x) {
    if (x == 0) return {};
    const auto& words = x.backend().bits();
    constexpr int word = sizeof(words.limbs()[0]) * 8;
    const int top = static_cast<int>(words.size()) - 1;
    double leading = std::ldexp(static_cast<double>(words.limbs()[top]), top * word - bits + 1);
    if (top > 0) {
      // One more: what the words below hold.
      const double next = static_cast<double>(words.limbs()[top - 1]) + 1.0;
      leading += std::ldexp(next, (top - 1) * word - bits + 1);
    }
    return Magnitude(leading, x.backend().exponent());
  }
  [[nodiscard]] Magnitude size() const { return size_of(value); }
  [[nodiscard]] bool is_exact() const { return !undefined && bound.is_zero(); }
  [[nodiscard]] bool is_exact_zero() const { return is_exact() && value == 0; }
  /// Is the error less than 2^-k times the number?
  [[nodiscard]] bool is_known_to(int k) const {
    return !undefined && value != 0 && bound * Magnitude(1.0 + 0x1p-40, k) < size();
  }
  [[nodiscard]] bool has_known_sign() const { return is_exact_zero() || is_known_to(0); }
};

template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> undefined_decimal() {
  BoundedDecimal<digits> result;
  result.undefined = true;
  return result;
}

template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> operator-(const BoundedDecimal<digits>& x) {
  BoundedDecimal<digits> result = x;
  result.value = -x.value;
  return result;
}
template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> operator+(const BoundedDecimal<digits>& x,
                                               const BoundedDecimal<digits>& y) {
  if (x.undefined || y.is_exact_zero()) return x;
  if (y.undefined || x.is_exact_zero()) return y;
  const Decimal<digits> value = x.value + y.value;
  if (value == 0 && x.is_exact() && y.is_exact()) return {};
  return {value, x.bound + y.bound};
}
template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> operator-(const BoundedDecimal<digits>& x,
                                               const BoundedDecimal<digits>& y) {
  return x + -y;
}
template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> operator*(const BoundedDecimal<digits>& x,
                                               const BoundedDecimal<digits>& y) {
  if (x.undefined || y.undefined) return undefined_decimal<digits>();
  // An unbounded number may have no value at all.
  if ((x.is_exact_zero() && y.bound.is_finite()) || (y.is_exact_zero() && x.bound.is_finite())) return {};
  if (!x.bound.is_finite()) return x;
  if (!y.bound.is_finite()) return y;
  return {Decimal<digits>(x.value * y.value), x.size() * y.bound + y.size() * x.bound + x.bound * y.bound};
}
template <unsigned digits>
[[nodiscard]] BoundedDecimal<digits> operator/(const BoundedDecimal<digits>& x,
                                               const BoundedDecimal<digits>& y) {
  if (x.undefined || y.undefined || y.is_exact_zero()) return undefined_decimal<digits>();
  if (!x.bound.is_finite()) return x;
  BoundedDecimal<digits> unbounded;
  unbounded.bound = Magnitude::infinite();
  if (!y.is_known_to(1)) return unbounded;
  if (x.is_exact_zero()) return x;
  const Decimal<digits> value = x.value / y.value;
  // y − e is more than |y|/2; where e is small the factor of 2 is no matter.
  const Magnitude carried = x.bound + BoundedDecimal<digits>::size_of(value) * y.bound;
  const Magnitude nearest_inverse = Magnitude(2.0 * (1.0 + 0x1p-30)) / y.size();
  const bool sharp = y.is_known_to(40);
  return {value, carried * (sharp ? Magnitude(1.0 + 0x1p-30) / y.size() : nearest_inverse)};
}

template <unsigned digits>
struct NumberTraits<BoundedDecimal<digits>> {
  using Number = BoundedDecimal<digits>;
  using T = Decimal<digits>;
  static constexpr bool has_lanes = false;
  static constexpr int lost_in_functions = 16;

  static Number root(const Number& x) {
    if (x.undefined || x.is_exact_zero()) return x;
    if (x.is_known_to(0) && x.value < 0) return undefined_decimal<digits>();
    Number result;
    result.bound = Magnitude::infinite();
    if (!x.is_known_to(0)) return result;
    const T value = sqrt(x.value);
    return {value, x.bound * Magnitude(1.0 + 0x1p-30) / Number::size_of(value)};
  }
  static Number absolute(const Number& x) { return x.value < 0 ? -x : x; }
  static Number sine(const Number& x) {
    return bounded(x, is_small(x), [](const T& argument) { return T(sin(argument)); });
  }
  static Number cosine(const Number& x) {
    return bounded(x, false, [](const T& argument) { return T(cos(argument)); });
  }
  static Number exponential(const Number& x) {
    if (x.undefined) return x;
    Number result;
    result.bound = Magnitude::infinite();
    if (Magnitude(0.5) < x.bound || x.value > 5e8) return result;
    if (x.value < -5e8) {
      result.bound = Magnitude(1.0, -700'000'000);  // more than e^(1/2 − 5e8)
      return result;
    }
    const T value = exp(x.value);
    const Magnitude library =
        (Magnitude(1.0) + x.size()) * Magnitude(1.0, lost_in_functions + 1 - Number::bits);
    return {value, Number::size_of(value) * (Magnitude(2.0) * x.bound + library)};
  }
  static Number tangent(const Number& x) { return sine(x) / cosine(x); }
  static Number hyperbolic_sine(const Number& x) {
    if (!x.undefined && is_small(x))  // a slope of 2 at most
      return bounded(doubled_bound(x), true, [](const T& argument) { return T(sinh(argument)); });
    return (exponential(x) - exponential(-x)) / Number(2.0);
  }
  static Number hyperbolic_cosine(const Number& x) {
    return (exponential(x) + exponential(-x)) / Number(2.0);
  }
  static Number hyperbolic_tangent(const Number& x) {
    if (!x.undefined && is_small(x)) return hyperbolic_sine(x) / hyperbolic_cosine(x);
    if (!x.undefined && x.value < 0) return -hyperbolic_tangent(-x);
    const Number falls = exponential(-(x + x));
    return (Number(1.0) - falls) / (Number(1.0) + falls);
  }
  static Number read(const std::string& text) { return {T(text), Magnitude{}, 1}; }

 private:
  static bool is_small(const Number& x) { return x.size() + x.bound < Magnitude(0.5); }
  static Number doubled_bound(const Number& x) {
    Number result = x;
    result.bound = x.bound + x.bound;
    return result;
  }
  /// From −1 to 1, with a slope of 1 at most. Where no digit would be right no function is called.
  template <class Function>
  static Number bounded(const Number& x, bool is_odd_and_small, const Function& function) {
    if (x.undefined || (is_odd_and_small && x.is_exact_zero())) return x;
    Number result;
    result.bound = x.bound.is_finite() ? Magnitude(1.0) : Magnitude::infinite();
    const Magnitude scale = is_odd_and_small ? x.size() : Magnitude(1.0) + x.size();
    const Magnitude error = x.bound + scale * Magnitude(1.0, lost_in_functions + 1 - Number::bits);
    if (!(error < Magnitude(0.5))) return result;
    return {function(x.value), error};
  }
};

}  // namespace rigor
