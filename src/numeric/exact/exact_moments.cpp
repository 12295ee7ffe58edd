// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/exact/exact_moments.h"

#include <algorithm>
#include <cmath>

#include "numeric/exact/exact_tensor.h"
#include "numeric/kernels/exact_characteristic.h"
#include "numeric/kernels/rotations.h"

namespace rigor {
namespace {

using Integers = std::array<Integer, 3>;

/// Of the entries alone.
using Characteristic = ExactCharacteristic<Integer>;

/// Ascending, where two are equal: the deviator's are q/p once and −q/2p twice. Roots of a monic polynomial
/// that are rational are integers.
Integers equal_roots(const Characteristic& of) {
  if (of.p == 0) return {of.c2 / 3, of.c2 / 3, of.c2 / 3};
  const Integer once = (of.c2 * of.p + of.q) / (3 * of.p);
  const Integer twice = (2 * of.c2 * of.p - of.q) / (6 * of.p);
  return once < twice ? Integers{once, twice, twice} : Integers{twice, twice, once};
}

/// Of χ(x/2^places): −1, 0 or 1.
int sign_at(const Characteristic& of, const Integer& x, int places) {
  const Integer value = ((x - (of.c2 << places)) * x + (of.c1 << 2 * places)) * x - (of.c0 << 3 * places);
  return value.sign();
}

int bits_of(const Integer& x) { return x == 0 ? 0 : static_cast<int>(msb(abs(x))) + 1; }

int greatest_bits(const ExactTensor& tensor) {
  int bits = 0;
  for (const auto& row : tensor.entries)
    for (const Integer& entry : row) bits = std::max(bits, bits_of(entry));
  return bits;
}

/// The integer as doubles times powers of two, the greatest first; until `take` of both is false. What is
/// left.
template <class Take>
Integer in_parts(Integer x, const Take& take) {
  const double sign = x < 0 ? -1 : 1;
  x = abs(x);
  while (x != 0) {
    const int drop = std::max(0, bits_of(x) - 53);
    const Integer leading = x >> drop;
    if (!take(sign * static_cast<double>(static_cast<std::uint64_t>(leading)), drop)) break;
    x -= leading << drop;
  }
  return x;
}

/// To its bits.
template <unsigned bits>
Binary<bits> binary(const Integer& x) {
  Binary<bits> sum = 0;
  int taken = 0;
  in_parts(x, [&](double part, int exponent) {
    sum += ldexp(Binary<bits>(part), exponent);
    taken += 53;
    return taken < static_cast<int>(bits) + 53;
  });
  return sum;
}

/// Roots of χ, ascending, in units of 2^-places.
struct Roots {
  Integers at;
  Integers errors{};  // at most
  int places = 0;
  std::array<Position, 3> axes{};
};

template <unsigned bits>
Rotated<Binary<bits>> diagonalised(const ExactTensor& tensor) {
  Rotated<Binary<bits>> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.a[i][j] = binary<bits>(tensor.entries[i][j]);
  r.diagonalise(ldexp(r.greatest(), -static_cast<int>(bits)));
  return r;
}

template <unsigned bits>
std::array<Position, 3> axes_of(const Rotated<Binary<bits>>& r) {
  std::array<Position, 3> axes{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) axes[k][i] = static_cast<double>(r.axes[k][i]);
  orient(axes);
  return axes;
}

/// Nothing where so many bits do not prove three roots apart by 2^60 times their errors.
template <unsigned bits>
std::optional<Roots> separate_roots(const ExactTensor& tensor, const Characteristic& characteristic) {
  constexpr int error_bits = 12;  // of units of 2^-bits of the greatest entry
  const Rotated<Binary<bits>> r = diagonalised<bits>(tensor);
  Roots roots;
  roots.places = std::max(0, static_cast<int>(bits) - greatest_bits(tensor));
  const int lost = std::max(0, greatest_bits(tensor) - static_cast<int>(bits));
  const Integer error = Integer(1) << (error_bits + lost);
  for (std::size_t k = 0; k < 3; ++k) {
    roots.at[k] = Integer(ldexp(r.a[k][k], roots.places));
    roots.errors[k] = error;
    if (k > 0 && roots.at[k] - roots.at[k - 1] < error << 60) return std::nullopt;
    if (sign_at(characteristic, roots.at[k] - error, roots.places) *
            sign_at(characteristic, roots.at[k] + error, roots.places) !=
        -1)
      return std::nullopt;
  }
  roots.axes = axes_of(r);
  return roots;
}

/// Integers as small as they can be: common powers of two are in the exponent.
ExactTensor reduced(ExactTensor tensor) {
  unsigned shared = ~0U;
  for (const auto& row : tensor.entries)
    for (const Integer& entry : row)
      if (entry != 0) shared = std::min(shared, static_cast<unsigned>(lsb(abs(entry))));
  if (shared == ~0U) return tensor;
  for (auto& row : tensor.entries)
    for (Integer& entry : row) entry /= Integer(1) << shared;
  const auto below = static_cast<unsigned>(lsb(tensor.divisor));
  tensor.divisor >>= below;
  tensor.exponent += static_cast<int>(shared) - static_cast<int>(below);
  return tensor;
}

/// x 2^exponent as doubles that do not overlap, the greatest first; what would be below 2^-1000 is left.
struct Parts {
  std::vector<double> parts;
  bool overflows = false;
  double left = 0;  // a bound of it
};

Parts parts_of(const Integer& x, int exponent) {
  constexpr int least = -1000;
  constexpr int most = 900;
  Parts result;
  const Integer left = in_parts(x, [&](double part, int drop) {
    result.overflows = result.overflows || exponent + drop > most;
    if (result.overflows || exponent + drop < least) return false;
    result.parts.push_back(std::ldexp(part, exponent + drop));
    return true;
  });
  if (left != 0) result.left = std::ldexp(1, least + 53);
  return result;
}

/// In as many bits as it takes to tell the third root from the two that are equal.
std::optional<Roots> equal_roots(const ExactTensor& tensor, const Characteristic& characteristic) {
  Roots roots{equal_roots(characteristic), {}, 0, {}};
  const Integer gap = roots.at[2] - roots.at[0];
  const int bits = gap == 0 ? 0 : greatest_bits(tensor) - bits_of(gap) + 80;
  if (bits > 4096) return std::nullopt;
  roots.axes = bits <= 256    ? axes_of(diagonalised<256>(tensor))
               : bits <= 1024 ? axes_of(diagonalised<1024>(tensor))
                              : axes_of(diagonalised<4096>(tensor));
  return roots;
}

std::optional<Roots> roots_of(const ExactTensor& tensor) {
  const Characteristic characteristic(tensor.entries);
  if (characteristic.discriminant_27() == 0) return equal_roots(tensor, characteristic);
  auto roots = separate_roots<256>(tensor, characteristic);
  if (!roots) roots = separate_roots<1024>(tensor, characteristic);
  if (!roots) roots = separate_roots<4096>(tensor, characteristic);
  if (!roots || characteristic.c0 != 0) return roots;
  for (std::size_t k = 0; k < 3; ++k) {  // one is 0
    if (abs(roots->at[k]) > roots->errors[k]) continue;
    roots->at[k] = 0;
    roots->errors[k] = 0;
  }
  return roots;
}

}  // namespace

std::optional<ExactMoments> exact_moments(const ExactTensor& given) {
  const ExactTensor tensor = reduced(given);
  const auto roots = roots_of(tensor);
  if (!roots) return std::nullopt;
  const int below = bits_of(tensor.divisor) - 1;  // numerators and divisor times 2^-below: 1 ≤ divisor < 2
  const int exponent = tensor.exponent - roots->places;
  const Parts divisor = parts_of(tensor.divisor, -below);
  if (divisor.left > 0) return std::nullopt;
  const auto value = [&](const Integer& x) {
    return ldexp(Binary<256>(binary<256>(x) / binary<256>(tensor.divisor)), exponent);
  };
  ExactMoments result;
  result.axes = roots->axes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Parts moment = parts_of(roots->at[k], exponent - below);
    const Parts error = parts_of(roots->errors[k], exponent - below);
    if (moment.overflows || error.overflows) return std::nullopt;
    result.moments[k] = {moment.parts, divisor.parts, moment.left + error.left};
    for (const double part : error.parts) result.moments[k].error += part * (1 + 0x1p-50);
    result.principal.moments[k] = rounded(value(roots->at[k]));
    if (k > 0) result.principal.gaps[k - 1] = static_cast<double>(value(roots->at[k] - roots->at[k - 1]));
  }
  return result;
}

}  // namespace rigor
