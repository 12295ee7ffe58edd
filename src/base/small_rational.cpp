// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/small_rational.h"

#include <limits>
#include <numeric>

namespace rigor {
namespace {

constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();

SmallRational no_number() { return {1, 0}; }

}  // namespace

SmallRational::SmallRational(std::int64_t over, std::int64_t under) : over_(over), under_(under) {
  if (under == 0 || over == lowest || under == lowest) {
    over_ = 1;
    under_ = 0;
    return;
  }
  const std::int64_t common = std::gcd(over, under) * (under < 0 ? -1 : 1);
  over_ /= common;
  under_ /= common;
}

std::string SmallRational::text() const {
  const std::string whole = std::to_string(over_);
  return under_ == 1 ? whole : whole + "/" + std::to_string(under_);
}

SmallRational operator+(const SmallRational& a, const SmallRational& b) {
  std::int64_t first = 0;
  std::int64_t second = 0;
  std::int64_t over = 0;
  std::int64_t under = 0;
  const bool overflow = __builtin_mul_overflow(a.over_, b.under_, &first) ||
                        __builtin_mul_overflow(b.over_, a.under_, &second) ||
                        __builtin_add_overflow(first, second, &over) ||
                        __builtin_mul_overflow(a.under_, b.under_, &under);
  return overflow ? no_number() : SmallRational(over, under);
}

SmallRational operator*(const SmallRational& a, const SmallRational& b) {
  std::int64_t over = 0;
  std::int64_t under = 0;
  const bool overflow =
      __builtin_mul_overflow(a.over_, b.over_, &over) || __builtin_mul_overflow(a.under_, b.under_, &under);
  return overflow ? no_number() : SmallRational(over, under);
}

SmallRational operator/(const SmallRational& a, const SmallRational& b) {
  if (!b.is_valid()) return no_number();
  return a * SmallRational(b.under_, b.over_);
}

}  // namespace rigor
