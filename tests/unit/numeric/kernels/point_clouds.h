// SPDX-License-Identifier: GPL-3.0-or-later
// The families of point masses that sums are tested on, and their exact sums.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/splitmix.h"
#include "numeric/kernels/mass_sums.h"
#include "numeric/program/uniform.h"

namespace rigor {

/// 120 digits, and exponents far beyond those of double.
using WideFloat = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>>;

struct PointCloud {
  std::string name;
  std::array<std::vector<double>, 4> columns;  // x, y, z, m

  [[nodiscard]] std::size_t size() const { return columns[3].size(); }
  [[nodiscard]] PointColumns points() const {
    return {{columns[0].data(), columns[1].data(), columns[2].data()}, columns[3].data(), size()};
  }
  [[nodiscard]] std::vector<double> records() const {
    std::vector<double> all;
    for (std::size_t k = 0; k < size(); ++k)
      for (const auto& column : columns) all.push_back(column[k]);
    return all;
  }
  void add(double x, double y, double z, double m) {
    const std::array<double, 4> point{x, y, z, m};
    for (std::size_t i = 0; i < 4; ++i) columns[i].push_back(point[i]);
  }
};

/// `count` points in the cube |x_i| ≤ 1 with masses in (0, 1], seen from a distance.
inline PointCloud cube_cloud(std::size_t count, double distance, std::uint64_t seed) {
  SplitMix bits(seed);
  PointCloud cloud{"cube of " + std::to_string(count) + " at " + std::to_string(distance), {}};
  for (std::size_t k = 0; k < count; ++k) {
    const double x = uniform_sign(bits) + distance;
    const double y = uniform_sign(bits) - distance / 3;
    cloud.add(x, y, uniform_sign(bits) + distance * 0.7, 1 - uniform(bits));
  }
  return cloud;
}

/// Every family, `count` points or so each.
inline std::vector<PointCloud> point_clouds(std::size_t count) {
  std::vector<PointCloud> all;
  for (const double distance : {0., 1., 1e2, 1e4, 1e6, 1e8, 1e10, 1e12})
    all.push_back(cube_cloud(count, distance, 11));
  const auto vary = [&](const std::string& name, double distance, const auto& change) {
    PointCloud cloud = cube_cloud(count, distance, 12);
    cloud.name = name + ", distance " + std::to_string(distance);
    SplitMix bits(13);
    for (std::size_t k = 0; k < cloud.size(); ++k) change(cloud.columns, k, bits);
    all.push_back(cloud);
  };
  using Columns = std::array<std::vector<double>, 4>;
  for (const double distance : {0., 1e4}) {
    vary("one mass of 1e16", distance,
         [&](Columns& c, std::size_t k, SplitMix&) { c[3][k] = k == count / 3 ? 1e16 : 1; });
    vary("masses from 1e-8 to 1e8", distance,
         [](Columns& c, std::size_t k, SplitMix& bits) { c[3][k] = std::pow(10, 8 * uniform_sign(bits)); });
    vary("no mass but one in a hundred", distance, [&](Columns& c, std::size_t k, SplitMix&) {
      if (k % 100 != 99 && k + 1 != count) c[3][k] = 0;
    });
    vary("collinear", distance, [](Columns& c, std::size_t k, SplitMix&) {
      c[1][k] = c[0][k] / 2;
      c[2][k] = 2 * c[0][k];
    });
    vary("coplanar", distance, [](Columns& c, std::size_t k, SplitMix&) { c[2][k] = c[0][k] + c[1][k]; });
    vary("a rod 1e-7 thick", distance, [](Columns& c, std::size_t k, SplitMix& bits) {
      c[1][k] = 1e-7 * uniform_sign(bits);
      c[2][k] = 1e-7 * uniform_sign(bits);
    });
    vary("sorted by x", distance, [](Columns& c, std::size_t k, SplitMix&) {
      if (k == 0) std::sort(c[0].begin(), c[0].end());
    });
    vary("two far clusters", distance, [](Columns& c, std::size_t k, SplitMix&) {
      if (k % 2 == 1) c[0][k] += 1e6;
    });
  }
  return all;
}

/// The same cloud with lengths and masses multiplied by powers of two: no digit changes.
inline PointCloud scaled_cloud(PointCloud cloud, int length, int mass) {
  for (std::size_t i = 0; i < 4; ++i)
    for (double& x : cloud.columns[i]) x = std::ldexp(x, i < 3 ? length : mass);
  return cloud;
}

/// By the textbook's two passes, in 120 digits.
struct ExactMassSums {
  WideFloat mass = 0;
  std::array<WideFloat, 3> centre{};
  std::array<std::array<WideFloat, 3>, 3> inertia{};
  WideFloat greatest = 0;  // entry

  explicit ExactMassSums(const PointCloud& cloud) {
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      mass += cloud.columns[3][k];
      for (std::size_t i = 0; i < 3; ++i) centre[i] += WideFloat(cloud.columns[3][k]) * cloud.columns[i][k];
    }
    for (WideFloat& x : centre) x /= mass;
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      std::array<WideFloat, 3> d;
      for (std::size_t i = 0; i < 3; ++i) d[i] = cloud.columns[i][k] - centre[i];
      const WideFloat square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          inertia[i][j] += cloud.columns[3][k] * ((i == j ? square : WideFloat(0)) - d[i] * d[j]);
    }
    for (const auto& row : inertia)
      for (const WideFloat& x : row) greatest = std::max<WideFloat>(greatest, abs(x));
  }

  /// The greatest error of an entry, relative to the greatest entry; infinite for what is not finite.
  [[nodiscard]] double error_of(const SharpTensor& tensor) const {
    WideFloat error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (!std::isfinite(tensor[i][j].high)) return std::numeric_limits<double>::infinity();
        const WideFloat difference = WideFloat(tensor[i][j].high) + tensor[i][j].low - inertia[i][j];
        error = std::max<WideFloat>(error, abs(difference));
      }
    }
    return error == 0 ? 0 : static_cast<double>(WideFloat(error / greatest));
  }
  [[nodiscard]] double error_of(const std::array<std::array<double, 3>, 3>& tensor) const {
    SharpTensor wide{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) wide[i][j].high = tensor[i][j];
    return error_of(wide);
  }
};

}  // namespace rigor
