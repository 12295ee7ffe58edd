// SPDX-License-Identifier: GPL-3.0-or-later
// Paths on an ellipsoid about the origin with its axes along 1, 2, 3, seen from (1, 1, 1) in isometric
// projection, as an SVG picture. What lies on the far side is drawn thin and light.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace rigor {

struct EllipsoidPath {
  std::string name;                           // in the legend
  std::vector<std::array<double, 3>> points;  // on the ellipsoid, or near it
};

struct EllipsoidPlot {
  std::string title;
  std::array<double, 3> half_axes{1, 1, 1};  // positive and finite
  std::array<std::string, 3> names = {};     // at the ends of the axes; mathematics between dollar signs
  std::vector<EllipsoidPath> paths = {};
};

/// Points that are not finite interrupt a path. Half axes that cannot be drawn give a picture that says so.
[[nodiscard]] std::string to_svg(const EllipsoidPlot& plot);

}  // namespace rigor
