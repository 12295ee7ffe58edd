// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/mesh_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/among.h"
#include "numeric/kernels/triangles.h"
#include "numeric/lane/mesh_totals.h"

namespace rigor {
namespace {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

/// x ↦ (x − origin) / 2^exponent, exactly and into [−1, 1].
struct Axis {
  double origin = 0;
  int exponent = 0;
  bool has_extent = false;
  bool is_exact = true;  // x − origin is, whatever x
};

enum class Differences { exact, exact_if_short };

/// For least ≤ x ≤ most. Where both have one sign and are within a factor of 4, so that an origin within a
/// factor of 2 of every x exists, it is the middle or the nearest such point. Else 0, which is then at most
/// 4/3 extents from all x; or, if x − origin need not be exact for numbers of more than 45 bits, the middle
/// to 8 bits of the extent, unless 0 is near.
Axis axis_for(double least, double most, Differences differences) {
  Axis axis;
  axis.has_extent = least < most;
  const double near = std::min(std::abs(least), std::abs(most));
  const double far = std::max(std::abs(least), std::abs(most));
  const double extent = most / 2 - least / 2;
  const double middle = most / 2 + least / 2;
  if ((least < 0) == (most < 0) && far / 4 <= near) {
    axis.origin = std::clamp(near / 2 + far / 2, far / 2, 2 * near) * (most < 0 ? -1 : 1);
  } else if (differences == Differences::exact_if_short && std::isfinite(extent) &&
             std::abs(middle) > extent / 4) {
    const double step = std::ldexp(1, std::ilogb(extent) - 8);
    axis.origin = step > 0 ? std::round(middle / step) * step : 0;
    axis.is_exact = axis.origin == 0;
  }
  const double size = std::max(std::abs(least - axis.origin), std::abs(most - axis.origin));
  if (size > 0 && std::isfinite(size)) axis.exponent = std::ilogb(size) + 1;
  return axis;
}

std::array<Axis, 3> axes_for(std::span<const Position> vertices, Differences differences,
                             const MeshKernels& kernels) {
  Position least{};
  Position most{};
  kernels.box(vertices.front().data(), vertices.size(), least.data(), most.data());
  std::array<Axis, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) axes[i] = axis_for(least[i], most[i], differences);
  return axes;
}

/// As the kernels read it, in one piece of a cache line.
struct alignas(4 * sizeof(double)) PackedVertex {
  double numbers[4];
};

PackedMesh pack(std::span<const Position> vertices, const std::array<Axis, 3>& axes,
                const MeshKernels& kernels, PackedVertex* packed) {
  Position origin{};
  Position scale{};
  bool try_exact = false;
  Position rest{};  // in two factors: 2^1074 is not a double
  for (std::size_t i = 0; i < 3; ++i) {
    const int half = -axes[i].exponent / 2;
    origin[i] = axes[i].origin;
    try_exact = try_exact || !axes[i].is_exact;
    scale[i] = std::ldexp(1, half);
    rest[i] = std::ldexp(1, -axes[i].exponent - half);
  }
  return kernels.pack(vertices.front().data(), vertices.size(), origin.data(), scale.data(), rest.data(),
                      try_exact, packed->numbers);
}

HighLow scaled_sharp(HighLow x, int exponent) {
  return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}

HighLow sharp(const double (&total)[2]) { return {total[0], total[1]}; }

/// What the sums say in the scaled axes.
struct Scaled {
  SharpPosition centre;
  SharpTensor second;  // lower triangle
};

Scaled scaled_moments(const MeshTotals& totals) {
  Scaled moments;
  const HighLow volumes = sharp(totals.volume);
  for (std::size_t i = 0; i < 3; ++i) {
    moments.centre[i] = sharp(totals.first[i]) / (volumes * 4.);
    for (std::size_t j = 0; j <= i; ++j)
      moments.second[i][j] =
          sharp(totals.second[i][j]) / (volumes * 20.) - moments.centre[i] * moments.centre[j];
  }
  return moments;
}

/// Rounding of everything but the sums: a dozen operations of at most 15 v, v = 2^-106.
constexpr double later_rounding = 0x1p-97;

/// Of the scaled moments; `rounding` is that of ΣD. For coordinates of at most 1 in size |s| ≤ 3 and |a_i a_j
/// + …| ≤ 12, so that the sums with them lack at most 3 and 12 times as much.
MeshErrors scaled_errors(const Scaled& moments, double six_volumes, double rounding) {
  MeshErrors errors;
  const double lost = rounding / (std::abs(six_volumes) - rounding);
  errors.volume = lost + later_rounding;
  for (std::size_t i = 0; i < 3; ++i)
    errors.centre[i] = lost * (3 / 4. + std::abs(moments.centre[i].high)) +
                       later_rounding * std::abs(moments.centre[i].high);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double fi = std::abs(moments.centre[i].high);
      const double fj = std::abs(moments.centre[j].high);
      const double sum = std::abs(moments.second[i][j].high) + fi * fj;  // ∫x_i x_j dV / V, or more
      const double error = lost * (12 / 20. + sum) + fi * errors.centre[j] + fj * errors.centre[i] +
                           errors.centre[i] * errors.centre[j] + later_rounding * (sum + fi * fj);
      errors.second_moments[i][j] = errors.second_moments[j][i] = error * (1 + 0x1p-20);
    }
    errors.greatest =
        std::max(errors.greatest, errors.second_moments[i][i] / std::abs(moments.second[i][i].high));
  }
  return errors;
}

/// Does the body fill 1/32 of its vertices' box, which has between 1 and 8 in the scaled axes? Then vertices
/// that are no corners cost no digits.
bool fills_box(const MeshTotals& totals) { return std::abs(totals.volume[0]) >= 6 * 8 / 32.; }

/// Do rounded terms keep the digits of every ∫x_i² dV? Where coordinates were rounded, too, the body must
/// fill a good part of the box, which has between 1 and 8 in the scaled axes: then it has not much surface to
/// move.
bool keeps_digits(const MeshTotals& totals, bool exact, const Scaled& moments) {
  const double six_volumes = std::abs(totals.volume[0]);
  if (!exact && !fills_box(totals)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(totals.size[i] <= 4 * 20 * six_volumes * moments.second[i][i].high)) return false;
  return true;
}

/// Back to metres. Fails where a number overflows.
Result<MeshMoments> in_metres(const MeshTotals& totals, const Scaled& from, const std::array<Axis, 3>& axes,
                              const MeshErrors& errors) {
  constexpr double last_place = 0x1p-1073;  // of two parts
  MeshMoments moments;
  moments.flat = totals.flat;
  moments.errors = errors;
  const HighLow volume = sharp(totals.volume) / HighLow{6, 0};
  moments.volume = scaled_sharp(volume, axes[0].exponent + axes[1].exponent + axes[2].exponent);
  if (!std::isfinite(moments.volume.high)) return refuse("the volume overflows");
  if (std::abs(moments.volume.high) < std::numeric_limits<double>::min())
    return refuse("the volume underflows");
  for (std::size_t i = 0; i < 3; ++i) {
    const HighLow centre = scaled_sharp(from.centre[i], axes[i].exponent);
    const HighLow sum = HighLow{centre.high, centre.low} + axes[i].origin;
    moments.centre[i] = {sum.high, sum.low};
    moments.errors.centre[i] =
        std::ldexp(errors.centre[i], axes[i].exponent) + 0x1p-104 * std::abs(sum.high) + last_place;
    for (std::size_t j = 0; j <= i; ++j) {
      moments.second_moments[i][j] = scaled_sharp(from.second[i][j], axes[i].exponent + axes[j].exponent);
      moments.second_moments[j][i] = moments.second_moments[i][j];
      moments.errors.second_moments[i][j] = moments.errors.second_moments[j][i] =
          std::ldexp(errors.second_moments[i][j], axes[i].exponent + axes[j].exponent) + last_place;
      if (!std::isfinite(moments.second_moments[i][j].high)) return refuse("the second moments overflow");
    }
  }
  return moments;
}

constexpr std::size_t few_triangles = 256;
constexpr double least_known = 0x1p-26;

/// The vertices that are corners, in their order, and the triangles of them.
Mesh without_unused(std::span<const Position> vertices, Triangles triangles) {
  std::vector<std::uint32_t> place(vertices.size());
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) place[corner] = 1;
  Mesh used;
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    if (place[n] == 0) continue;
    place[n] = static_cast<std::uint32_t>(used.vertices.size());
    used.vertices.push_back(vertices[n]);
  }
  used.triangles.assign(triangles.begin(), triangles.end());
  for (auto& triangle : used.triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
  return used;
}

bool are_all_used(std::size_t vertices, Triangles triangles) {
  std::vector<std::uint8_t> used(vertices);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) used[corner] = 1;
  return !is_one_of(0, used);
}

}  // namespace

Result<void> check_second_moments(const std::array<double, 3>& moments, const MeshErrors& errors) {
  if (!(errors.greatest < least_known))
    return refuse(fmt::format(
        "the mesh encloses too little of its box: a second moment is known only to {:.0e} of its value",
        errors.greatest));
  for (const double moment : moments)
    if (!(moment > 0))
      return refuse(
          "the second moments are not positive: the surface passes through itself, or one of several is "
          "turned inside out");
  return {};
}

Result<void> check_corners(std::size_t vertices, Triangles triangles, const LaneKernels& kernels) {
  if (triangles.empty()) return {};
  if (vertices == 0 || vertices > 0x80000000U)
    return refuse(fmt::format("the mesh has {} vertices", vertices));
  const auto last = static_cast<std::uint32_t>(vertices - 1);
  if (kernels.mesh.corners(triangles.front().data(), 3 * triangles.size(), last)) return {};
  for (std::size_t n = 0;; ++n) {
    for (const std::uint32_t corner : triangles[n])
      if (corner >= vertices)
        return refuse(
            fmt::format("triangle {} has the vertex {} of {}", n + 1, std::uint64_t{corner} + 1, vertices));
  }
}

Result<MeshMoments> mesh_moments(std::span<const Position> vertices, Triangles triangles,
                                 MeshSharpness sharpness, const LaneKernels& kernels) {
  if (triangles.empty()) return refuse("the mesh has no triangles");
  if (const auto checked = check_corners(vertices.size(), triangles, kernels); !checked)
    return tl::unexpected(checked.error());
  const auto packed = std::make_unique_for_overwrite<PackedVertex[]>(vertices.size());
  std::array<Axis, 3> axes;
  MeshTotals totals;
  const auto sum = [&](bool in_double_double) {
    axes =
        axes_for(vertices, in_double_double ? Differences::exact : Differences::exact_if_short, kernels.mesh);
    const PackedMesh state = pack(vertices, axes, kernels.mesh, packed.get());
    kernels.mesh.sums(packed[0].numbers, triangles.front().data(), triangles.size(), in_double_double,
                      totals);
    return state;
  };
  bool is_sharp = sharpness == MeshSharpness::always || triangles.size() < few_triangles;
  const PackedMesh state = sum(is_sharp);
  if (!state.finite) return refuse("a coordinate of the mesh is not finite");
  if (!fills_box(totals) && !are_all_used(vertices.size(), triangles)) {
    const Mesh used = without_unused(vertices, triangles);
    return mesh_moments(used.vertices, used.triangles, sharpness, kernels);
  }
  Scaled moments = scaled_moments(totals);
  if (!is_sharp && !keeps_digits(totals, state.exact, moments)) {
    is_sharp = true;
    sum(true);
    moments = scaled_moments(totals);
  }
  // Each D is wrong by 2^-99 at most. 16 of a lane are added with 16² 2^-106 of their sizes, the sums of
  // those and at last the lanes with 3 · 2^-106 of all sizes each, N/128 + 8 times; one by one, N/8 + 8
  // times.
  const auto count = static_cast<double>(triangles.size());
  const double sizes = totals.sizes * (1 + 0x1p-20) + count * 0x1p-99;
  const double rounding = count * mesh_flat + sizes * (0x1p-97 + count * 0x1p-106);
  for (const Axis& axis : axes)
    if (!axis.has_extent) return refuse("the mesh encloses no volume");
  if (std::abs(totals.volume[0]) <= rounding) return refuse("the mesh encloses no volume");
  const MeshErrors errors = scaled_errors(moments, totals.volume[0], rounding);
  const auto checked = check_second_moments(
      {moments.second[0][0].high, moments.second[1][1].high, moments.second[2][2].high}, errors);
  if (!checked) return tl::unexpected(checked.error());
  Result<MeshMoments> result = in_metres(totals, moments, axes, errors);
  if (result) result->sharp = is_sharp;
  return result;
}

}  // namespace rigor
