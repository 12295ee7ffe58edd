// SPDX-License-Identifier: GPL-3.0-or-later
// A sum of products of up to three doubles without any rounding: an integer in units far below the smallest
// product, as U. W. Kulisch, W. L. Miranker, SIAM Rev. 28 (1986) 1. Carries wait in 64 bits for 2^30 terms.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace rigor {

using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// ± digits 2^exponent: a double exactly.
struct Dyadic {
  std::uint64_t digits = 1;
  int exponent = 0;
  bool is_negative = false;
};

/// x must be finite.
[[nodiscard]] inline Dyadic dyadic(double x) {
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  return {static_cast<std::uint64_t>(std::ldexp(fraction, 53)), exponent - 53, std::signbit(x)};
}

class LongSum {
 public:
  /// Of the unit in which `value` counts: three factors of 2^-1126, the last place of a subnormal number.
  static constexpr int lowest = 3 * -1126;

  /// 6 ns.
  void add(const Dyadic& a, const Dyadic& b = {}, const Dyadic& c = {}) {
    __extension__ using Wide = unsigned __int128;
    const Wide two = Wide{a.digits} * b.digits;
    const Wide low = Wide{static_cast<std::uint64_t>(two)} * c.digits;
    const Wide high = (two >> 64) * c.digits + (low >> 64);
    const std::array<std::uint64_t, 3> words{static_cast<std::uint64_t>(low),
                                             static_cast<std::uint64_t>(high),
                                             static_cast<std::uint64_t>(high >> 64)};
    const int place = a.exponent + b.exponent + c.exponent - lowest;
    const int shift = place % limb_bits;
    std::int64_t* limb = limbs_.data() + place / limb_bits;
    const std::int64_t sign = a.is_negative != (b.is_negative != c.is_negative) ? -1 : 1;
    for (const std::uint64_t word : words) {
      for (const std::uint64_t half : {word & limb_mask, word >> limb_bits}) {
        const std::uint64_t shifted = half << shift;
        limb[0] += sign * static_cast<std::int64_t>(shifted & limb_mask);
        limb[1] += sign * static_cast<std::int64_t>(shifted >> limb_bits);
        ++limb;
      }
    }
  }

  /// In units of 2^lowest.
  [[nodiscard]] Integer value() const {
    Integer sum = 0;
    for (std::size_t k = limbs_.size(); k-- > 0;) sum = (sum << limb_bits) + limbs_[k];
    return sum;
  }

 private:
  static constexpr int limb_bits = 32;
  static constexpr std::uint64_t limb_mask = 0xffffffff;
  /// Three factors below 2^1024, and room for the last word.
  static constexpr int limbs = (3 * 1024 - lowest) / limb_bits + 8;
  std::array<std::int64_t, limbs> limbs_{};
};

}  // namespace rigor
