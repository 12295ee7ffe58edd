// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "numeric/body/known_moments.h"
#include "numeric/lane/double_double.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

using enum ShapeKind;

constexpr auto shapes = std::to_array<ShapeInfo>({
    {rod, "rod", {0, 0, 1}, {1, 1, 3}},
    {hoop, "hoop", {1, 1, 0}, {2, 2, 1}},
    {disc, "disc", {1, 1, 0}, {4, 4, 1}},
    {plate, "plate", {1, 1, 0}, {3, 3, 1}},
    {box, "box", {1, 1, 1}, {3, 3, 3}},
    {sphere, "sphere", {1, 1, 1}, {5, 5, 5}},
    {shell, "spherical shell", {1, 1, 1}, {3, 3, 3}},
    {ellipsoid, "ellipsoid", {1, 1, 1}, {5, 5, 5}},
    {cylinder, "cylinder", {1, 1, 1}, {4, 4, 3}},
    {cone, "cone", {3, 3, 3}, {20, 20, 80}},
});

constexpr bool shapes_follow_enum() {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (static_cast<std::size_t>(shapes[i].kind) != i) return false;
  return static_cast<std::size_t>(cone) + 1 == shapes.size();
}
static_assert(shapes_follow_enum(), "one entry for each kind, in the order of the enumeration");

/// Uniform in the unit cube.
Position draw_cube(SplitMix& bits) {
  Position point{};
  for (double& x : point) x = uniform_sign(bits);
  return point;
}

/// Uniform in the unit shape, by rejection from the cube: no function of <cmath> but the square root, which
/// is correctly rounded everywhere. Expected tries: at most 12/π for the cone.
Position draw(ShapeKind kind, SplitMix& bits) {
  for (;;) {
    auto [x, y, z] = draw_cube(bits);
    const double rho = x * x + y * y;
    const double square = rho + z * z;
    switch (kind) {
      case rod:
        return {0, 0, z};
      case plate:
        return {x, y, 0};
      case box:
        return {x, y, z};
      case disc:
        if (rho <= 1) return {x, y, 0};
        break;
      case cylinder:
        if (rho <= 1) return {x, y, z};
        break;
      case hoop:
        if (rho <= 1 && rho > 0x1p-40) return {x / std::sqrt(rho), y / std::sqrt(rho), 0};
        break;
      case sphere:
      case ellipsoid:
        if (square <= 1) return {x, y, z};
        break;
      case shell:
        if (square <= 1 && square > 0x1p-40)
          return {x / std::sqrt(square), y / std::sqrt(square), z / std::sqrt(square)};
        break;
      case cone: {
        const double down = (1 - z) / 2;  // from the apex
        if (rho <= down * down) return {x, y, 0.75 - down};
        break;
      }
    }
  }
}

/// Moves each point by +x and by −x along an axis. Each point's antipode stays behind it.
void split(std::vector<Position>& points, std::size_t axis, double x) {
  const std::vector<Position> before = std::exchange(points, {});
  const std::size_t stride = before.size() == 1 ? 1 : 2;
  for (std::size_t pair = 0; pair < before.size(); pair += stride) {
    for (const double sign : {1.0, -1.0}) {
      points.push_back(before[pair]);
      points.back()[axis] = sign * x;
      if (stride == 1) continue;
      points.push_back(before[pair + 1]);
      points.back()[axis] = -sign * x;
    }
  }
}

ExactTensor exact_inertia_of(const Shape& shape) {
  const ShapeInfo& kind = info(shape.kind);
  const auto whole = [](double x) { return Integer(static_cast<int>(x)); };
  ExactTensor inertia;
  inertia.divisor = whole(kind.under[0]) * whole(kind.under[1]) * whole(kind.under[2]);
  inertia.exponent = LongSum::lowest;
  for (std::size_t k = 0; k < 3; ++k) {
    LongSum square;
    square.add(dyadic(shape.mass), dyadic(shape.extents[k]), dyadic(shape.extents[k]));
    const Integer second = square.value() * whole(kind.over[k]) * (inertia.divisor / whole(kind.under[k]));
    inertia.entries[(k + 1) % 3][(k + 1) % 3] += second;
    inertia.entries[(k + 2) % 3][(k + 2) % 3] += second;
  }
  return inertia;
}

}  // namespace

std::span<const ShapeInfo> shape_table() { return shapes; }

const ShapeInfo& info(ShapeKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  RIGOR_CHECK(index < shapes.size(), index);
  return shapes[index];
}

Result<void> check_shape(const Shape& shape) {
  const ShapeInfo& kind = info(shape.kind);
  if (!std::isfinite(shape.mass) || shape.mass <= 0)
    return refuse(
        fmt::format("the {} has the mass {} kg, which must be finite and positive", kind.name, shape.mass));
  for (std::size_t k = 0; k < 3; ++k) {
    const double extent = shape.extents[k];
    if (kind.over[k] > 0 && (!std::isfinite(extent) || extent <= 0))
      return refuse(fmt::format("the {} has the half extent {} m, which must be finite and positive",
                                kind.name, extent));
  }
  return {};
}

Result<KnownInertia> inertia_of(const Shape& shape) {
  if (const auto checked = check_shape(shape); !checked) return tl::unexpected(checked.error());
  const ShapeInfo& kind = info(shape.kind);
  KnownInertia known{.mass = shape.mass, .is_sharp = true};
  const auto second_moment = [&](std::size_t k) {
    const HighLow square = baseline::exact_product(shape.extents[k], shape.extents[k]);
    return square * kind.over[k] / HighLow{kind.under[k], 0};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const HighLow moment = (second_moment((i + 1) % 3) + second_moment((i + 2) % 3)) * shape.mass;
    if (!std::isfinite(moment.high))
      return refuse(fmt::format("the {}'s moments of inertia overflow", kind.name));
    known.inertia[i][i] = moment.high;
    known.low[i][i] = moment.low;
    known.error = std::max(known.error, 0x1p-100 * moment.high + 0x1p-1073);  // 45 v
  }
  tell_moments_apart(known, exact_body(exact_inertia_of(shape), shape.mass));
  return known;
}

Result<Body> quadrature_body(std::string name, const Shape& shape) {
  const auto known = inertia_of(shape);
  if (!known) return tl::unexpected(known.error());
  const ShapeInfo& kind = info(shape.kind);
  std::vector<Position> points{{0, 0, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (kind.over[k] > 0) split(points, k, shape.extents[k] * std::sqrt(kind.over[k] / kind.under[k]));
  }
  Body body{std::move(name),
            std::vector<double>(points.size(), shape.mass / static_cast<double>(points.size())),
            {},
            *known,
            {},
            {.place = 4 * 0x1p-53}};
  for (const Position& point : points) {
    for (std::size_t k = 0; k < 3; ++k) body.positions[k].push_back(point[k]);
  }
  return body;
}

Result<Body> sampled_body(std::string name, const Shape& shape, std::size_t count, std::uint64_t seed) {
  const auto known = inertia_of(shape);
  if (!known) return tl::unexpected(known.error());
  if (count == 0) return refuse("the body has no particles");
  if (count > most_particles)
    return refuse(fmt::format("the body has {} particles, at most {}", count, most_particles));
  SplitMix bits(seed);
  Body body{
      std::move(name),  std::vector<double>(count, shape.mass / static_cast<double>(count)), {}, *known, {},
      {.mass = 0x1p-53}};
  for (std::size_t i = 0; i < count; ++i) {
    const Position unit = draw(shape.kind, bits);
    for (std::size_t k = 0; k < 3; ++k) body.positions[k].push_back(unit[k] * shape.extents[k]);
  }
  return centred(std::move(body));
}

}  // namespace rigor
