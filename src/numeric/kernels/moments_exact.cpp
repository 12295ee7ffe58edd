// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/moments_exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/check.h"
#include "numeric/kernels/exact_characteristic.h"
#include "numeric/kernels/rotations.h"

namespace rigor {
namespace {

namespace mp = boost::multiprecision;
template <unsigned bits>
using Fixed =
    mp::number<mp::cpp_int_backend<bits, bits, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;

/// How many results are 0.
struct Zeros {
  int moments = 0;
  int gaps = 0;
};

/// The exponents of the last place of any entry, or less, and beyond its first.
struct Places {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
};

Places places_of(const SharpTensor& a) {
  Places places;
  for (const auto& row : a) {
    for (const HighLow& entry : row) {
      for (const double part : {entry.high, entry.low}) {
        if (part == 0) continue;
        places.lowest = std::min(places.lowest, std::ilogb(part) - 52);
        places.highest = std::max(places.highest, std::ilogb(part) + 1);
      }
    }
  }
  return places;
}

/// 2^-lowest of a number, as an integer.
template <class Integer>
Integer in_units(const HighLow& a, int lowest) {
  Integer sum = 0;
  for (const double part : {a.high, a.low}) {
    if (part == 0) continue;
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(part, &exponent), 53));
    const int places = exponent - 53 - lowest;
    sum += places >= 0 ? Integer(Integer(digits) << places) : Integer(digits >> -places);
  }
  return sum;
}

/// x 2^exponent, to 2^-60 of itself; of its root if `of_root`.
struct Rounded {
  double x = 0;
  int exponent = 0;
};

template <class Integer>
Rounded rounded_root(const Integer& n, int exponent, bool of_root) {
  if (n == 0) return {};
  const Integer size = n < 0 ? Integer(-n) : n;
  int drop = std::max(0, static_cast<int>(msb(size)) - 62);
  if (of_root && (drop + exponent) % 2 != 0) ++drop;  // less than a bit
  const auto x = static_cast<double>(static_cast<std::int64_t>(Integer(size >> drop)));
  if (of_root) return {std::sqrt(x), (drop + exponent) / 2};
  return {n < 0 ? 0 - x : x, drop + exponent};
}

/// What the characteristic polynomial λ³ − c₂λ² + c₁λ − c₀ tells exactly.
struct Invariants {
  Zeros zeros;
  Rounded product;       // c₀, of the moments
  Rounded gaps_product;  // the root of the discriminant
};

template <class Integer>
Invariants invariants_in(const SharpTensor& tensor, int lowest) {
  std::array<std::array<Integer, 3>, 3> a;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) a[i][j] = a[j][i] = in_units<Integer>(tensor[i][j], lowest);
  }
  const ExactCharacteristic<Integer> exact(a);
  const Integer discriminant = exact.discriminant_27() / 27;
  Invariants result;
  if (exact.c0 == 0) result.zeros.moments = exact.c1 != 0 ? 1 : exact.c2 != 0 ? 2 : 3;
  result.zeros.gaps = exact.p == 0 ? 2 : discriminant == 0 ? 1 : 0;
  result.product = rounded_root(exact.c0, 3 * lowest, false);
  result.gaps_product = rounded_root(discriminant, 6 * lowest, true);
  return result;
}

Invariants invariants_of(const SharpTensor& tensor) {
  const Places places = places_of(tensor);
  // Of entries of n bits, nothing that is computed has more than 6n + 20 bits.
  const int bits = 6 * (places.highest - places.lowest) + 24;
  if (bits < 512) return invariants_in<Fixed<512>>(tensor, places.lowest);
  if (bits < 1024) return invariants_in<Fixed<1024>>(tensor, places.lowest);
  return invariants_in<mp::cpp_int>(tensor, places.lowest);
}

/// Diagonal to `unit`, which is 2^-bits of the greatest entry. Cyclic Jacobi converges quadratically: 12
/// sweeps for 8,192 bits.
template <unsigned bits>
Rotated<Binary<bits>> rotated(const SharpTensor& tensor, Binary<bits>& unit) {
  Rotated<Binary<bits>> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const HighLow& entry = tensor[std::max(i, j)][std::min(i, j)];
      r.a[i][j] = Binary<bits>(entry.high) + Binary<bits>(entry.low);
    }
  }
  unit = ldexp(r.greatest(), -static_cast<int>(bits));
  r.diagonalise(unit);
  return r;
}

bool is_finite(const PrincipalMoments& principal) {
  for (const HighLow& moment : principal.moments) {
    if (!std::isfinite(moment.high)) return false;
  }
  return std::isfinite(principal.gaps[0]) && std::isfinite(principal.gaps[1]);
}

/// Results of so many bits; false where what is not exactly 0 does not stand out of the rounding errors, also
/// where it rounds to 0. Those of the rotations are less than 2^10 units of the greatest entry, and 2^60
/// beyond them are wanted.
template <unsigned bits>
bool stands_out(const SharpTensor& tensor, const Zeros& zeros, PrincipalAxes& result) {
  Binary<bits> unit;
  Rotated<Binary<bits>> r = rotated<bits>(tensor, unit);
  const Binary<bits> least = ldexp(unit, 10 + 60);
  std::array<std::size_t, 3> by_size = {0, 1, 2};
  std::ranges::sort(by_size, [&](std::size_t i, std::size_t j) { return abs(r.a[i][i]) < abs(r.a[j][j]); });
  std::array<Binary<bits>, 2> gaps = {r.a[1][1] - r.a[0][0], r.a[2][2] - r.a[1][1]};
  const std::size_t smaller = gaps[0] <= gaps[1] ? 0 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    auto& value = r.a[by_size[k]][by_size[k]];
    if (std::cmp_less(k, zeros.moments))
      value = 0;
    else if (abs(value) < least)
      return false;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_zero = zeros.gaps == 2 || (zeros.gaps == 1 && k == smaller);
    if (!is_zero && gaps[k] < least) return false;
    if (is_zero) {
      gaps[k] = 0;
      r.a[k + 1][k + 1] = r.a[k][k];
    }
    result.principal.gaps[k] = static_cast<double>(gaps[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    result.principal.moments[k] = rounded(r.a[k][k]);
    for (std::size_t i = 0; i < 3; ++i) result.axes[k][i] = static_cast<double>(r.axes[k][i]);
  }
  orient(result.axes);
  return true;
}

/// x 2^e/(a b).
double quotient(const Rounded& x, double a, double b) {
  int power_of_a = 0;
  int power_of_b = 0;
  const double ratio = x.x / std::frexp(a, &power_of_a) / std::frexp(b, &power_of_b);
  return std::ldexp(ratio, x.exponent - power_of_a - power_of_b);
}

PrincipalAxes sorted_diagonal(const SharpTensor& a) {
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return (a[i][i] - a[j][j]).high < 0; });
  PrincipalAxes result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.principal.moments[k] = a[order[k]][order[k]];
    result.axes[k][order[k]] = 1;
  }
  for (std::size_t k = 0; k < 2; ++k)
    result.principal.gaps[k] = (result.principal.moments[k + 1] - result.principal.moments[k]).high;
  orient(result.axes);
  return result;
}

}  // namespace

bool is_diagonal(const SharpTensor& tensor) {
  return tensor[1][0].high == 0 && tensor[2][0].high == 0 && tensor[2][1].high == 0;
}

std::optional<PrincipalAxes> solved_in_many_digits(const SharpTensor& tensor) {
  for (const auto& row : tensor) {
    for (const HighLow& entry : row) {
      if (!std::isfinite(entry.high) || !std::isfinite(entry.low)) return std::nullopt;
    }
  }
  PrincipalAxes result;
  if (is_diagonal(tensor)) {
    result = sorted_diagonal(tensor);
  } else {
    const Zeros zeros = invariants_of(tensor).zeros;
    const bool found = stands_out<256>(tensor, zeros, result) || stands_out<1024>(tensor, zeros, result) ||
                       stands_out<8192>(tensor, zeros, result);
    RIGOR_CHECK(found, zeros.gaps, zeros.moments);
  }
  if (!is_finite(result.principal)) return std::nullopt;
  return result;
}

MendedResults mend_by_invariants(const SharpTensor& tensor, const SmallResults& small,
                                 PrincipalMoments& principal) {
  const Invariants exact = invariants_of(tensor);
  if (exact.zeros.gaps == 2) return {};
  constexpr double large_enough =
      0x1p-30;  // relative to the greatest moment: the kernel has it to 2^-70 then
  auto& moments = principal.moments;
  if (small.moment) {
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
      return std::abs(moments[i].high) < std::abs(moments[j].high);
    });
    const double middle = moments[order[1]].high;
    const double most = moments[order[2]].high;
    if (exact.zeros.moments == 2) {
      moments[order[0]] = moments[order[1]] = {};
    } else if (std::abs(middle) >= large_enough * std::abs(most)) {
      moments[order[0]] = {quotient(exact.product, middle, most), 0};
    } else {
      return {};
    }
  }
  if (small.gap) {
    const std::size_t smaller = principal.gaps[0] <= principal.gaps[1] ? 0 : 1;
    const double other = principal.gaps[1 - smaller];
    principal.gaps[smaller] = quotient(exact.gaps_product, other, other + principal.gaps[smaller]);
    if (exact.zeros.gaps == 1) moments[smaller + 1] = moments[smaller];
  }
  return {true, exact.zeros.gaps > 0};
}

}  // namespace rigor
