// SPDX-License-Identifier: GPL-3.0-or-later
#include "mass_sums_cases.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

#include "bench_clock.h"
#include "numeric/kernels/point_clouds.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {
namespace {

using Tensor = std::array<std::array<double, 3>, 3>;

/// The same points in the layouts that methods ask for.
struct BenchPoints {
  explicit BenchPoints(const PointCloud& cloud)
      : columns(cloud.points()), records(cloud.records()), masses(cloud.columns[3]) {
    for (std::size_t k = 0; k < cloud.size(); ++k)
      positions.emplace_back(cloud.columns[0][k], cloud.columns[1][k], cloud.columns[2][k]);
  }

  PointColumns columns;
  std::vector<double> records;
  std::vector<double> masses;
  std::vector<Eigen::Vector3d> positions;
};

Tensor tensor_of(const Eigen::Matrix3d& matrix) {
  Tensor tensor{};
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      tensor[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = matrix(i, j);
  return tensor;
}

Tensor eigen_two_passes(const BenchPoints& points) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < points.masses.size(); ++k) {
    mass += points.masses[k];
    centre += points.masses[k] * points.positions[k];
  }
  centre /= mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < points.masses.size(); ++k) {
    const Eigen::Vector3d r = points.positions[k] - centre;
    inertia += points.masses[k] * (r.dot(r) * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return tensor_of(inertia);
}

/// What one writes who knows Eigen well: two passes over columns, in blocks that stay in the cache. One block
/// is centred once, and its six sums are products of columns.
Tensor eigen_columns(const BenchPoints& points) {
  constexpr Eigen::Index block = 512;
  using Column = Eigen::Map<const Eigen::ArrayXd>;
  using Block = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, block, 1>;
  const auto count = static_cast<Eigen::Index>(points.columns.count);
  const auto column = [&](std::size_t i, Eigen::Index at, Eigen::Index size) {
    return Column(points.columns.position[i] + at, size);
  };
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (Eigen::Index at = 0; at < count; at += block) {
    const Eigen::Index size = std::min(block, count - at);
    const Column m(points.columns.mass + at, size);
    mass += m.sum();
    for (std::size_t i = 0; i < 3; ++i)
      centre[static_cast<Eigen::Index>(i)] += (m * column(i, at, size)).sum();
  }
  centre /= mass;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index at = 0; at < count; at += block) {
    const Eigen::Index size = std::min(block, count - at);
    const Column m(points.columns.mass + at, size);
    const Block x = column(0, at, size) - centre[0];
    const Block y = column(1, at, size) - centre[1];
    const Block z = column(2, at, size) - centre[2];
    const Block mx = m * x;
    const Block my = m * y;
    second(0, 0) += (mx * x).sum();
    second(0, 1) += (mx * y).sum();
    second(0, 2) += (mx * z).sum();
    second(1, 1) += (my * y).sum();
    second(1, 2) += (my * z).sum();
    second(2, 2) += (m * z * z).sum();
  }
  const Eigen::Matrix3d whole = second.selfadjointView<Eigen::Upper>();
  return tensor_of(whole.trace() * Eigen::Matrix3d::Identity() - whole);
}

/// Σ m, Σ m x_i and Σ m x_i x_j in ten numbers: a 3×3 matrix to which outer products are added takes three
/// times as long.
Tensor one_pass(const BenchPoints& points) {
  double mass = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, yy = 0, zz = 0, yz = 0, zx = 0, xy = 0;
  for (std::size_t k = 0; k < points.masses.size(); ++k) {
    const double m = points.masses[k];
    const Eigen::Vector3d& r = points.positions[k];
    const double mx = m * r.x();
    const double my = m * r.y();
    const double mz = m * r.z();
    mass += m;
    x += mx;
    y += my;
    z += mz;
    xx += mx * r.x();
    yy += my * r.y();
    zz += mz * r.z();
    yz += my * r.z();
    zx += mz * r.x();
    xy += mx * r.y();
  }
  const Eigen::Vector3d first(x, y, z);
  Eigen::Matrix3d second;
  second << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  second -= first * first.transpose() / mass;
  return tensor_of(second.trace() * Eigen::Matrix3d::Identity() - second);
}

/// A plain sum over the four columns at once, with the kernel's prefetching: as fast as they can be read, a
/// lower bound for any method.
Tensor plain_read(const BenchPoints& points) {
  using Eight = Eigen::Array<double, 8, 1>;
  constexpr std::size_t ahead = 256;
  const std::array<const double*, 4> columns = {points.columns.position[0], points.columns.position[1],
                                                points.columns.position[2], points.columns.mass};
  std::array<Eight, 4> sums;
  sums.fill(Eight::Zero());
  for (std::size_t k = 0; k + 8 <= points.columns.count; k += 8) {
    for (std::size_t i = 0; i < 4; ++i) {
      __builtin_prefetch(columns[i] + k + ahead);
      sums[i] += Eigen::Map<const Eight>(columns[i] + k);
    }
  }
  Tensor tensor{};
  for (const Eight& column : sums) tensor[0][0] += column.sum();
  return tensor;
}

/// A failure is not a number.
Tensor failed() {
  Tensor tensor{};
  for (auto& row : tensor) row.fill(std::numeric_limits<double>::quiet_NaN());
  return tensor;
}

Tensor inertia_of(const Result<MassSums>& sums) { return sums ? sums->inertia : failed(); }

Tensor inertia_of(const Result<SharpMassSums>& sums) {
  if (!sums) return failed();
  Tensor tensor{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) tensor[i][j] = sums->inertia[i][j].high;
  return tensor;
}

struct PointMethod {
  std::string name;
  std::function<Tensor(const BenchPoints&)> inertia;
  bool is_inertia = true;
};

std::vector<PointMethod> point_methods() {
  const auto records = [](const BenchPoints& points) {
    return point_records(points.records.data(), points.masses.size());
  };
  return {
      {"read", plain_read, false},
      {"Eigen, two passes", eigen_two_passes},
      {"Eigen, columns in blocks", eigen_columns},
      {"one pass about the origin", one_pass},
      {"kernel", [](const BenchPoints& p) { return inertia_of(mass_sums(p.columns)); }},
      {"kernel, 2 threads", [](const BenchPoints& p) { return inertia_of(mass_sums(p.columns, {2})); }},
      {"kernel, records", [=](const BenchPoints& p) { return inertia_of(mass_sums(records(p))); }},
      {"kernel, sharp", [](const BenchPoints& p) { return inertia_of(sharp_mass_sums(p.columns)); }},
      {"kernel, sharp, records",
       [=](const BenchPoints& p) { return inertia_of(sharp_mass_sums(records(p))); }},
  };
}

std::vector<KernelRow> times() {
  struct Size {
    std::size_t count;
    const char* where;
  };
  std::vector<KernelRow> rows;
  for (const auto& [count, where] :
       {Size{1'024, "L1"}, Size{2'048, "L2"}, Size{16'384, "L2"}, Size{10'000'000, "memory"}}) {
    const PointCloud cloud = cube_cloud(count, 10, 1);
    const BenchPoints points(cloud);
    for (const PointMethod& method : point_methods()) {
      volatile double sink = 0;
      const double time = least_nanoseconds([&] { sink = method.inertia(points)[0][0]; });
      rows.push_back({"inertia of points, time", method.name, fmt::format("{} points in {}", count, where),
                      time / static_cast<double>(count), 0, "a point"});
    }
  }
  return rows;
}

std::vector<KernelRow> errors() {
  std::vector<KernelRow> rows;
  for (const PointCloud& cloud : point_clouds(1'000)) {
    const BenchPoints points(cloud);
    const ExactMassSums exact(cloud);
    for (const PointMethod& method : point_methods()) {
      if (!method.is_inertia) continue;
      const double time = least_nanoseconds([&] { return method.inertia(points)[0][0]; });
      rows.push_back({"inertia of points, error", method.name, cloud.name,
                      time / static_cast<double>(cloud.size()), exact.error_of(method.inertia(points)),
                      "a point"});
    }
  }
  return rows;
}

}  // namespace

std::vector<KernelRow> mass_sums_rows() {
  std::vector<KernelRow> rows = times();
  std::ranges::copy(errors(), std::back_inserter(rows));
  return rows;
}

}  // namespace rigor
