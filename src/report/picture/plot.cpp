// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/picture/plot_panel.h"

namespace rigor {

std::string to_svg(std::span<const Plot> plots) {
  double height = 0;
  std::string title;
  for (const Plot& plot : plots) {
    height += plot_height(plot);
    title += (title.empty() ? "" : "; ") + plot.title;
  }
  Svg svg(plot_width, std::max(height, 1.0), title);
  double top = 0;
  for (const Plot& plot : plots) {
    draw_plot(svg, plot, top);
    top += plot_height(plot);
  }
  return svg.finish();
}

std::string to_svg(const Plot& plot) { return to_svg(std::span<const Plot>(&plot, 1)); }

Mark mark_at(std::size_t position) {
  constexpr std::array marks{Mark::circle, Mark::square, Mark::triangle, Mark::diamond,      Mark::cross,
                             Mark::plus,   Mark::ring,   Mark::star,     Mark::triangle_down};
  return marks[position % marks.size()];
}

PlotSeries pareto_front(std::string name, std::span<const PlotSeries> series) {
  std::vector<PlotPoint> points;
  for (const PlotSeries& each : series) {
    for (const PlotPoint& point : each.points) {
      if (std::isfinite(point.x) && std::isfinite(point.y)) points.push_back({point.x, point.y});
    }
  }
  std::ranges::sort(
      points, [](const PlotPoint& a, const PlotPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  PlotSeries front{.name = std::move(name), .points = {}, .mark = Mark::none, .stroke = Stroke::dotted};
  double best = std::numeric_limits<double>::infinity();
  for (const PlotPoint& point : points) {
    if (point.y >= best) continue;
    best = point.y;
    front.points.push_back(point);
  }
  return front;
}

}  // namespace rigor
