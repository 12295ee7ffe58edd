// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/moment_families.h"

#include <cmath>
#include <functional>
#include <limits>

#include "numeric/program/uniform.h"

namespace rigor {
namespace {

using Rotation = std::array<std::array<Digits50, 3>, 3>;

/// M(q) of the quaternion (w, x, y, z): |q|² times a rotation.
template <class Number>
std::array<std::array<Number, 3>, 3> unnormalised_rotation(const Number& w, const std::array<Number, 3>& v) {
  std::array<std::array<Number, 3>, 3> m{};
  const Number square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    m[i][i] = w * w - square + 2 * v[i] * v[i];
    m[i][j] = 2 * (v[i] * v[j] - w * v[k]);
    m[i][k] = 2 * (v[i] * v[k] + w * v[j]);
  }
  return m;
}

Rotation random_rotation(SplitMix& bits) {
  const Digits50 w = uniform_sign(bits);
  std::array<Digits50, 3> v;
  for (Digits50& x : v) x = uniform_sign(bits);
  Rotation m = unnormalised_rotation(w, v);
  const Digits50 square = w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  for (auto& row : m)
    for (Digits50& x : row) x /= square;
  return m;
}

/// M diag(moments) Mᵀ, rounded once.
InertiaTensor turned(const std::array<Digits50, 3>& moments, const Rotation& m) {
  InertiaTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Digits50 sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += m[i][k] * moments[k] * m[j][k];
      tensor[i][j] = tensor[j][i] = static_cast<double>(sum);
    }
  }
  return tensor;
}

/// Eight points in a cube with masses in (0, 1].
InertiaTensor random_body(SplitMix& bits) {
  InertiaTensor tensor{};
  for (int point = 0; point < 8; ++point) {
    const double mass = 1 - uniform(bits);
    const Position r{uniform_sign(bits), uniform_sign(bits), uniform_sign(bits)};
    const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) tensor[i][j] += mass * ((i == j ? square : 0) - r[i] * r[j]);
    }
  }
  return tensor;
}

/// Moments of a body two of which differ by `gap` of the norm: a flat or a long one.
InertiaTensor nearly_symmetric(SplitMix& bits, double gap) {
  const bool flat = bits.below(2) == 0;
  const Digits50 equal = (1 + uniform(bits)) / 2;
  const Digits50 third = flat ? equal * (1 + uniform(bits)) : equal * uniform(bits);
  const Digits50 norm = flat ? third : equal;
  return turned({equal, equal - gap * norm, third}, random_rotation(bits));
}

InertiaTensor nearly_spherical(SplitMix& bits) {
  constexpr std::array gaps{1e-4, 1e-8, 1e-12};
  const double gap = gaps[bits.below(gaps.size())];
  const double size = 1 - uniform(bits);
  std::array<Digits50, 3> moments;
  for (Digits50& moment : moments) moment = size * (1 + Digits50(gap) * uniform_sign(bits));
  return turned(moments, random_rotation(bits));
}

double small_integer(SplitMix& bits, std::size_t most) {
  return static_cast<double>(bits.below(2 * most + 1)) - static_cast<double>(most);
}

/// Integers that have these integers, times |q|⁴, as their moments exactly.
InertiaTensor turned_integers(SplitMix& bits, const Position& moments) {
  const double w = 1 + static_cast<double>(bits.below(7));
  std::array<double, 3> v{};
  for (double& x : v) x = small_integer(bits, 7);
  Rotation m;
  const auto exact = unnormalised_rotation(w, v);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = exact[i][j];
  return turned({moments[0], moments[1], moments[2]}, m);
}

InertiaTensor exactly_symmetric(SplitMix& bits) {
  const auto equal = static_cast<double>(1 + bits.below(1000));
  const auto third = bits.below(8) == 0 ? equal : static_cast<double>(1 + bits.below(1000));
  return turned_integers(bits, {equal, equal, third});
}

InertiaTensor exact_rod_or_plate(SplitMix& bits) {
  const auto first = static_cast<double>(1 + bits.below(1000));
  const auto second = static_cast<double>(1 + bits.below(1000));
  return bits.below(2) == 0 ? turned_integers(bits, {0, first, first})
                            : turned_integers(bits, {first, second, first + second});
}

/// Zero, multiples of the identity, diagonal tensors of either order with equal or negative ones among them,
/// and v vᵀ of integers.
InertiaTensor simple_tensor(SplitMix& bits) {
  InertiaTensor tensor{};
  switch (bits.below(4)) {
    case 0:
      if (bits.below(8) != 0) tensor[0][0] = tensor[1][1] = tensor[2][2] = uniform_sign(bits);
      break;
    case 1:
      for (std::size_t i = 0; i < 3; ++i) tensor[i][i] = uniform_sign(bits);
      break;
    case 2:
      for (std::size_t i = 0; i < 3; ++i) tensor[i][i] = small_integer(bits, 3);
      break;
    default:
      Position v{};
      for (double& x : v) x = small_integer(bits, 1 << 20);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) tensor[i][j] = v[i] * v[j];
  }
  return tensor;
}

InertiaTensor graded(SplitMix& bits) {
  return turned(
      {1 - uniform(bits), Digits50(1e-4) * (1 - uniform(bits)), Digits50(1e-8) * (1 - uniform(bits))},
      random_rotation(bits));
}

/// Thickness 1e-1 to 1e-6 of the length.
InertiaTensor thin_rod(SplitMix& bits) {
  constexpr std::array squares{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  const Digits50 square = squares[bits.below(squares.size())] * (1 - uniform(bits));
  return turned({square, 1 + square * uniform(bits), 1 + square * uniform(bits)}, random_rotation(bits));
}

InertiaTensor almost_aligned(SplitMix& bits) {
  std::array<Digits50, 3> v;
  for (Digits50& x : v) x = 1e-9 * uniform_sign(bits);
  Rotation m = unnormalised_rotation(Digits50(1), v);
  std::array<Digits50, 3> moments;
  for (Digits50& moment : moments) moment = 1 - uniform(bits);
  if (bits.below(2) == 0) moments[1] = moments[0] * (1 - Digits50(1e-8));
  return turned(moments, m);
}

/// A random body, a nearly symmetric or a thin one.
InertiaTensor any_body(SplitMix& bits) {
  switch (bits.below(4)) {
    case 0:
      return thin_rod(bits);
    case 1:
      return nearly_symmetric(bits, 1e-8);
    default:
      return random_body(bits);
  }
}

/// Bodies with two equal moments, and a link of a robot is one, in any attitude: the doubles that hold them
/// have three different moments.
InertiaTensor turned_cylinder(SplitMix& bits) {
  const Digits50 square = 1 - uniform(bits);        // of the radius
  const Digits50 height = 4 * (1 - uniform(bits));  // squared
  const Digits50 across = square / 4 + height / 12;
  return turned({across, across, square / 2}, random_rotation(bits));
}

/// Of an aspect between 1e-3 and 1e-7.
InertiaTensor turned_rod(SplitMix& bits) {
  constexpr std::array aspects{1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
  const Digits50 aspect = aspects[bits.below(aspects.size())] * (1 - Digits50(uniform(bits)) / 2);
  const Digits50 square = aspect * aspect;
  const Digits50 across = square / 4 + Digits50(1) / 12;
  return turned({across, across, square / 2}, random_rotation(bits));
}

InertiaTensor turned_sphere(SplitMix& bits) {
  const Digits50 moment = 1 - uniform(bits);
  return turned({moment, moment, moment}, random_rotation(bits));
}

/// Moments and sines of the attitude are doubles of few bits: two moments are equal exactly.
InertiaTensor cylinder_by_eighths(SplitMix& bits) {
  const double across = 1 + static_cast<double>(bits.below(64));
  const double along = 1 + static_cast<double>(bits.below(64));
  std::array<double, 3> axis{};
  const std::size_t first = bits.below(3);
  axis[first] = 1;
  if (bits.below(2) == 0) axis[(first + 1) % 3] = bits.below(2) == 0 ? 1 : -1;
  const double square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  InertiaTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      tensor[i][j] = (i == j ? across : 0) + (along - across) * axis[i] * axis[j] / square;
  return tensor;
}

InertiaTensor scaled(InertiaTensor tensor, int power) {
  for (Position& row : tensor)
    for (double& x : row) x = std::ldexp(x, power);
  return tensor;
}

/// Of a few bodies, by each of the 48 signed permutations of the axes in turn.
InertiaTensor permuted(SplitMix& bits) {
  SplitMix few(bits.below(16));
  const InertiaTensor tensor = any_body(few);
  const std::size_t which = bits.below(48);
  std::array<std::size_t, 3> axes{which % 3, (which + 1) % 3, (which + 2) % 3};
  if (which % 2 != 0) std::swap(axes[1], axes[2]);
  InertiaTensor result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool minus = ((which / 6 >> i) ^ (which / 6 >> j)) % 2 != 0;
      result[i][j] = minus ? -tensor[axes[i]][axes[j]] : tensor[axes[i]][axes[j]];
    }
  }
  return result;
}

}  // namespace

std::vector<MomentFamily> moment_families(std::size_t count) {
  std::vector<MomentFamily> families;
  const auto add = [&](std::string name, const std::function<InertiaTensor(SplitMix&)>& make) {
    SplitMix bits(families.size() + 1);
    families.push_back({std::move(name), {}});
    for (std::size_t k = 0; k < count; ++k) families.back().tensors.push_back(make(bits));
  };
  add("random bodies", random_body);
  for (const char* gap : {"1e-4", "1e-8", "1e-12", "1e-15"})
    add(std::string("gap ") + gap, [=](SplitMix& bits) { return nearly_symmetric(bits, std::stod(gap)); });
  add("nearly equal", nearly_spherical);
  add("equal integers", exactly_symmetric);
  add("integer rods, plates", exact_rod_or_plate);
  add("0, 1, diagonal, rank 1", simple_tensor);
  add("1 : 1e-4 : 1e-8", graded);
  add("thin rods", thin_rod);
  add("almost aligned", almost_aligned);
  add("permuted, reflected", permuted);
  const auto add_scaled = [&](const char* scale, int power) {
    add(std::string("scale ") + scale, [=](SplitMix& bits) { return scaled(any_body(bits), power); });
  };
  add_scaled("1e150", 498);
  add_scaled("1e-150", -498);
  add_scaled("1e300", 997);
  add_scaled("1e-300", -997);
  add_scaled("subnormal", -1045);
  add("turned cylinders", turned_cylinder);
  add("turned rods", turned_rod);
  add("turned spheres", turned_sphere);
  add("eighths of a turn", cylinder_by_eighths);
  for (const char* gap : {"1e-13", "1e-14", "1e-16"})
    add(std::string("gap ") + gap, [=](SplitMix& bits) { return nearly_symmetric(bits, std::stod(gap)); });
  return families;
}

std::vector<SharpTensor> close_pairs(double gap, std::size_t count) {
  std::vector<SharpTensor> tensors(count);
  SplitMix bits(count);
  for (SharpTensor& tensor : tensors) {
    const std::array<Digits50, 3> moments = {1, 1 + Digits50(gap), 2 * uniform(bits)};
    const Rotation m = random_rotation(bits);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Digits50 sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += m[i][k] * moments[k] * m[j][k];
        const auto high = static_cast<double>(sum);
        tensor[i][j] = tensor[j][i] = {high, static_cast<double>(Digits50(sum - high))};
      }
    }
  }
  return tensors;
}

std::vector<InertiaTensor> unusable_tensors() {
  SplitMix bits(1);
  const InertiaTensor body = random_body(bits);
  std::vector<InertiaTensor> tensors;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        tensors.push_back(body);
        tensors.back()[i][j] = tensors.back()[j][i] = bad;
      }
    }
  }
  return tensors;
}

}  // namespace rigor
