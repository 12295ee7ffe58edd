// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/exact/exact_tensor.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t most_triangles = 100'000;
constexpr int most_bits = 400;

using IntegerVector = std::array<Integer, 3>;

/// Entries for i ≤ j, and the same below the diagonal.
template <class Entry>
std::array<IntegerVector, 3> symmetric_entries(const Entry& entry) {
  std::array<IntegerVector, 3> all;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) all[i][j] = all[j][i] = entry(i, j);
  return all;
}

/// 2^-lowest of a double, as an integer; its own last place is at or above `lowest`, or it is 0.
Integer whole_units(double x, int lowest) {
  const Dyadic d = dyadic(x);
  if (d.digits == 0) return 0;
  const int places = d.exponent - lowest;
  const Integer size = places >= 0 ? Integer(d.digits) << places : Integer(d.digits >> -places);
  return d.is_negative ? Integer(-size) : size;
}

/// Of the places that are needed for some doubles: from the last one that is not 0 to the first.
struct BitRange {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();

  void add(double x) {
    Dyadic d = dyadic(x);
    if (d.digits == 0) return;
    highest = std::max(highest, d.exponent + 53);
    lowest = std::min(lowest, d.exponent + __builtin_ctzll(d.digits));
  }
};

/// tr(S) 1 − S.
ExactTensor inertia_of_solid(const ExactTensor& second_moments) {
  const auto& s = second_moments.entries;
  ExactTensor inertia = second_moments;
  inertia.entries = symmetric_entries([&](std::size_t i, std::size_t j) {
    return Integer(i == j ? s[(i + 1) % 3][(i + 1) % 3] + s[(i + 2) % 3][(i + 2) % 3] : -s[i][j]);
  });
  return inertia;
}

/// As small as they can be.
ExactBody stripped(ExactBody body) {
  if (body.mass != 0) {
    const auto places = static_cast<unsigned>(lsb(body.mass));
    body.mass >>= places;
    body.mass_exponent += static_cast<int>(places);
  }
  ExactTensor& inertia = body.inertia;
  Integer shared = inertia.divisor;
  for (const auto& row : inertia.entries)
    for (const Integer& entry : row) shared = gcd(shared, entry);
  inertia.divisor /= shared;
  for (auto& row : inertia.entries)
    for (Integer& entry : row) entry /= shared;
  return body;
}

ExactTensor sum_of_tensors(const ExactTensor& a, const ExactTensor& b) {
  ExactTensor sum;
  sum.exponent = std::min(a.exponent, b.exponent);
  sum.divisor = a.divisor * b.divisor;
  const Integer of_a = b.divisor << (a.exponent - sum.exponent);
  const Integer of_b = a.divisor << (b.exponent - sum.exponent);
  sum.entries = symmetric_entries(
      [&](std::size_t i, std::size_t j) { return Integer(a.entries[i][j] * of_a + b.entries[i][j] * of_b); });
  return sum;
}

}  // namespace

ExactBody exact_body(const PointColumns& points) {
  struct Sums {
    LongSum mass;
    std::array<LongSum, 3> first;
    std::array<std::array<LongSum, 3>, 3> second;  // i ≤ j
  };
  const auto sums = std::make_unique<Sums>();
  for (std::size_t k = 0; k < points.count; ++k) {
    const Dyadic m = dyadic(points.mass[points.stride * k]);
    if (m.digits == 0) continue;
    std::array<Dyadic, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = dyadic(points.position[i][points.stride * k]);
    sums->mass.add(m);
    for (std::size_t i = 0; i < 3; ++i) {
      sums->first[i].add(m, x[i]);
      for (std::size_t j = i; j < 3; ++j) sums->second[i][j].add(m, x[i], x[j]);
    }
  }
  ExactTensor second;
  second.divisor = sums->mass.value();
  second.exponent = LongSum::lowest;  // twice above, once below
  IntegerVector first;
  for (std::size_t i = 0; i < 3; ++i) first[i] = sums->first[i].value();
  second.entries = symmetric_entries([&](std::size_t i, std::size_t j) {
    return Integer(second.divisor * sums->second[i][j].value() - first[i] * first[j]);
  });
  return stripped({inertia_of_solid(second), second.divisor, LongSum::lowest});
}

ExactBody exact_body(const ExactTensor& inertia, double mass) {
  const Dyadic m = dyadic(mass);
  return stripped({inertia, Integer(m.digits), m.exponent});
}

ExactBody exact_joined(std::span<const PlacedExactBody> parts) {
  BitRange places;
  int unit = std::numeric_limits<int>::max();
  for (const PlacedExactBody& part : parts) {
    unit = std::min(unit, part.body->mass_exponent);
    for (const double x : part.at) places.add(x);
  }
  const int length = places.lowest > places.highest ? 0 : places.lowest;
  Integer mass = 0;
  IntegerVector first{};
  std::array<IntegerVector, 3> second{};
  for (const PlacedExactBody& part : parts) {
    const Integer own = part.body->mass << (part.body->mass_exponent - unit);
    IntegerVector x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = whole_units(part.at[i], length);
    mass += own;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += own * x[i];
      for (std::size_t j = i; j < 3; ++j) second[i][j] += own * x[i] * x[j];
    }
  }
  ExactTensor between;
  between.divisor = mass;
  between.exponent = unit + 2 * length;
  between.entries = symmetric_entries(
      [&](std::size_t i, std::size_t j) { return Integer(mass * second[i][j] - first[i] * first[j]); });
  ExactTensor inertia = inertia_of_solid(between);
  for (const PlacedExactBody& part : parts) inertia = sum_of_tensors(inertia, part.body->inertia);
  return stripped({inertia, mass, unit});
}

ExactBody along_axis(const ExactBody& body, std::size_t step) {
  ExactBody turned = body;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      turned.inertia.entries[(i + step) % 3][(j + step) % 3] = body.inertia.entries[i][j];
  return turned;
}

std::optional<ExactSolid> exact_solid(const Mesh& mesh) {
  BitRange places;
  for (const Position& vertex : mesh.vertices)
    for (const double x : vertex) places.add(x);
  if (mesh.triangles.size() > most_triangles || places.highest < places.lowest ||
      places.highest - places.lowest > most_bits)
    return std::nullopt;
  std::vector<IntegerVector> from_first(mesh.vertices.size());
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      from_first[n][i] =
          whole_units(mesh.vertices[n][i], places.lowest) - whole_units(mesh.vertices[0][i], places.lowest);
  Integer volume = 0;
  IntegerVector first{};
  std::array<IntegerVector, 3> second{};
  for (const auto& triangle : mesh.triangles) {
    const IntegerVector& a = from_first[triangle[0]];
    const IntegerVector& b = from_first[triangle[1]];
    const IntegerVector& c = from_first[triangle[2]];
    Integer determinant = 0;
    IntegerVector sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      determinant += a[i] * (b[j] * c[k] - b[k] * c[j]);
      sum[i] = a[i] + b[i] + c[i];
    }
    if (determinant == 0) continue;
    volume += determinant;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += determinant * sum[i];
      for (std::size_t j = i; j < 3; ++j)
        second[i][j] += determinant * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum[i] * sum[j]);
    }
  }
  if (volume == 0) return std::nullopt;
  ExactSolid solid{abs(volume), 3 * places.lowest, {}, {}, places.lowest - 2, volume < 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Integer from_origin = first[i] + 4 * volume * whole_units(mesh.vertices[0][i], places.lowest);
    solid.centre[i] = volume < 0 ? Integer(-from_origin) : from_origin;
  }
  solid.second_moments.divisor = 80 * volume * volume;
  solid.second_moments.exponent = 2 * places.lowest;
  solid.second_moments.entries = symmetric_entries([&](std::size_t i, std::size_t j) {
    return Integer(4 * volume * second[i][j] - 5 * first[i] * first[j]);
  });
  return solid;
}

ExactTensor exact_tensor(const InertiaTensor& tensor) {
  BitRange places;
  for (const Position& row : tensor)
    for (const double entry : row) places.add(entry);
  ExactTensor exact;
  exact.exponent = places.lowest > places.highest ? 0 : places.lowest;
  exact.entries = symmetric_entries(
      [&](std::size_t i, std::size_t j) { return whole_units(tensor[j][i], exact.exponent); });
  return exact;
}

ExactTensor times(ExactTensor tensor, double factor) {
  const Dyadic d = dyadic(factor);
  tensor.exponent += d.exponent;
  for (auto& row : tensor.entries)
    for (Integer& entry : row) entry *= d.is_negative ? -Integer(d.digits) : Integer(d.digits);
  return tensor;
}

HighLow rounded_quotient(const Integer& above, const Integer& below, int exponent) {
  if (above == 0) return {};
  // To 160 bits at least.
  const auto bits = [](const Integer& x) { return static_cast<int>(msb(abs(x))); };
  const int places = std::max(0, 160 - bits(above) + bits(below));
  Integer quotient = (abs(above) << places) / below;
  const int drop = std::max(0, bits(quotient) - 52);
  const Integer leading = quotient >> drop;
  quotient -= leading << drop;
  const int second = std::max(0, drop - 53);
  const auto part = [&](const Integer& x, int power) {
    const double size =
        std::ldexp(static_cast<double>(static_cast<std::uint64_t>(x)), power + exponent - places);
    return above < 0 ? -size : size;
  };
  return baseline::exact_sum(part(leading, drop), part(quotient >> second, second));
}

ExactSolid times_unit(ExactSolid solid, double unit) {
  const Dyadic d = dyadic(unit);
  solid.volume *= Integer(d.digits) * d.digits * d.digits;
  solid.exponent += 3 * d.exponent;
  solid.centre_exponent += d.exponent;
  for (Integer& x : solid.centre) x *= Integer(d.digits) * d.digits * d.digits * d.digits;
  solid.second_moments = times(times(std::move(solid.second_moments), unit), unit);
  return solid;
}

ExactTensor inertia_with_mass(const ExactSolid& solid, double mass) {
  return times(inertia_of_solid(solid.second_moments), mass);
}

ExactTensor inertia_with_density(const ExactSolid& solid, double density) {
  ExactTensor inertia = inertia_with_mass(solid, density);
  for (auto& row : inertia.entries)
    for (Integer& entry : row) entry *= solid.volume;
  inertia.divisor *= 6;
  inertia.exponent += solid.exponent;
  return inertia;
}

}  // namespace rigor
