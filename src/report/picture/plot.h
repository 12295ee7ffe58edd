// SPDX-License-Identifier: GPL-3.0-or-later
// Curves and points over two axes, as an SVG picture. It can be read in grey: series differ in lightness,
// dashes and marks. The same plot gives the same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rigor {

enum class Mark : std::uint8_t {
  none,
  circle,
  square,
  triangle,
  diamond,
  cross,
  plus,
  ring,
  star,
  triangle_down
};
enum class Stroke : std::uint8_t { none, solid, dashed, dotted };

/// Infinity lies on the upper edge (a point at x = ∞ on the right one), 0 on a logarithmic axis on the lower
/// one, and both are named there. Where a value is not a number, or negative on a logarithmic axis, a curve
/// is interrupted.
struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string label = {};
};

struct PlotSeries {
  std::string name;  // in the legend; empty: none
  std::vector<PlotPoint> points;
  Mark mark = Mark::none;
  Stroke stroke = Stroke::solid;
  int colour = -1;  // which of the palette; -1: the series' position
};

struct PlotAxis {
  std::string label;
  bool logarithmic = false;
};

/// All texts may contain mathematics between dollar signs (`svg_label`).
struct Plot {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
};

/// Of the series at this position where each has one: nine in turn, so that 45 series with the colours of
/// their positions, five in turn, all differ.
[[nodiscard]] Mark mark_at(std::size_t position);

/// One below the other in one picture.
[[nodiscard]] std::string to_svg(std::span<const Plot> plots);
[[nodiscard]] std::string to_svg(const Plot& plot);

/// The points that no other beats: none is at most as large in both x and y. Ordered by x; for the line that
/// marks them in a plot of time against error.
[[nodiscard]] PlotSeries pareto_front(std::string name, std::span<const PlotSeries> series);

}  // namespace rigor
