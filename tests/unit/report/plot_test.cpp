// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "catch.h"
#include "report/picture/plot_ellipsoid.h"
#include "report/picture/plot_scale.h"
#include "report/picture/svg_label.h"

namespace rigor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

Plot points_of(std::vector<PlotPoint> points, bool logarithmic) {
  Plot plot{"title", {"x", logarithmic}, {"y", logarithmic}, {}};
  plot.series.push_back({"a", std::move(points), Mark::circle, Stroke::none});
  return plot;
}

TEST_CASE("the same plot gives the same bytes", "[plot]") {
  const Plot plot = points_of({{1, 1e-16, "p"}, {10, 1e-3, "q"}, {12, infinity, "r"}}, true);
  CHECK(to_svg(plot) == to_svg(plot));
}

TEST_CASE("text in a plot cannot become markup", "[plot]") {
  Plot plot = points_of({{1, 1, "<script>alert(1)</script>"}}, false);
  plot.title = "a < b & \"c\"";
  plot.series[0].name = "</svg>";
  const std::string svg = to_svg(plot);
  CHECK(svg.find("<script") == std::string::npos);
  CHECK(count(svg, "</svg>") == 1);
  CHECK(svg.find("a &lt; b &amp; &quot;c&quot;") != std::string::npos);
}

TEST_CASE("an infinite error lies on the upper edge and is named", "[plot]") {
  const std::string svg = to_svg(points_of({{1, 1}, {2, infinity}}, true));
  CHECK(count(svg, "<circle") == 3);  // two points and the legend
  CHECK(svg.find(">∞</text>") != std::string::npos);
  CHECK(to_svg(points_of({{1, 1}, {2, 3}}, true)).find("∞") == std::string::npos);
}

TEST_CASE("an error of zero lies on the lower edge of a logarithmic axis and is named", "[plot]") {
  const std::string svg = to_svg(points_of({{1, 1}, {2, 0}}, true));
  CHECK(count(svg, "<circle") == 3);
  CHECK(svg.find(">0</text>") != std::string::npos);
}

TEST_CASE("a point that is not a number is left out and interrupts its curve", "[plot]") {
  Plot plot = points_of({{0, 0}, {1, 1}, {2, std::nan("")}, {3, 1}, {4, 2}}, false);
  CHECK(count(to_svg(plot), "<circle") == 5);
  plot.series[0].stroke = Stroke::solid;
  CHECK(count(to_svg(plot), "<polyline") == 2);
}

TEST_CASE("a plot without points, or of extreme ones, is still a picture", "[plot]") {
  CHECK(to_svg(points_of({}, true)).find("</svg>") != std::string::npos);
  CHECK(to_svg(points_of({}, false)).find("</svg>") != std::string::npos);
  for (const bool logarithmic : {false, true}) {
    const std::string svg = to_svg(
        points_of({{1e308, -1e308}, {-1e308, 1e308}, {5e-324, 5e-324}, {-infinity, 0}, {3, 3}, {0, -0.0}},
                  logarithmic));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}

TEST_CASE("forty-five series differ in their mark or in their colour", "[plot]") {
  std::set<std::string> pictures;
  for (int position = 0; position < 45; ++position) {
    Plot plot = points_of({{1, 1}}, false);
    plot.series[0].mark = mark_at(static_cast<std::size_t>(position));
    plot.series[0].colour = position;
    pictures.insert(to_svg(plot));
  }
  CHECK(pictures.size() == 45);
}

TEST_CASE("a time that is infinite lies on the right edge of a logarithmic axis", "[plot]") {
  const std::string svg = to_svg(points_of({{1, 1}, {10, 2}, {infinity, infinity}}, true));
  CHECK(count(svg, "<circle") == 4);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("the front holds the points that no other beats", "[plot]") {
  const std::vector<PlotSeries> series{{"a", {{3, 1}, {1, 5}, {2, 6}, {5, infinity}}},
                                       {"b", {{1, 7}, {4, 1}, {9, 0}}}};
  const PlotSeries front = pareto_front("front", series);
  REQUIRE(front.points.size() == 3);
  CHECK((front.points[0].x == 1 && front.points[0].y == 5));
  CHECK((front.points[1].x == 3 && front.points[1].y == 1));
  CHECK((front.points[2].x == 9 && front.points[2].y == 0));
}

TEST_CASE("ticks are at round values inside the scale", "[plot]") {
  const PlotScale scale = fitting_scale({0.13, 0.87}, false);
  CHECK(scale.low < 0.13);
  CHECK(scale.high > 0.87);
  std::string labels;
  for (const Tick& tick : ticks_of(scale)) labels += tick.label + " ";
  CHECK(labels == "0.2 0.4 0.6 0.8 ");
  const auto decades = ticks_of(fitting_scale({1e-30, 1}, true));
  CHECK(decades.size() <= 34);
  CHECK(std::count_if(decades.begin(), decades.end(), [](const Tick& tick) { return !tick.label.empty(); }) <=
        10);
}

TEST_CASE("a constant is drawn as a constant, not as its rounding errors", "[plot]") {
  const PlotScale scale = fitting_scale({1.0, 1.0 + 1e-15}, false);
  CHECK(scale.high - scale.low > 0.4);
}

TEST_CASE("names in drawings are read as LaTeX writes them", "[plot]") {
  CHECK(svg_label("$\\omega_1$ (rad/s)") ==
        "<tspan font-style=\"italic\">ω</tspan><tspan dy=\"4.00\" font-size=\"75%\">1</tspan>"
        "<tspan dy=\"-4.00\">\u200b</tspan> (rad/s)");
  CHECK(svg_label("$\\mathbf{L}$") == "<tspan font-weight=\"bold\">L</tspan>");
  CHECK(svg_label("$\\wibble$") == "<tspan>wibble</tspan>");
  CHECK(svg_label("5 $ and no more") == "5 $ and no more");
  const std::string deep(5000, '{');
  CHECK(svg_label("$" + deep + "$").size() < 100000);
  CHECK(svg_label("$" + std::string(3000, '_') + "a$").size() < 1000000);
}

TEST_CASE("a path behind the ellipsoid is drawn lighter than one before it", "[plot]") {
  EllipsoidPlot plot{"p", {3, 2, 1}, {"1", "2", "3"}, {}};
  plot.paths.push_back({"front", {{0, 0, 1}, {0.1, 0, 1}, {0.1, 0.1, 1}}});
  CHECK(count(to_svg(plot), "stroke-opacity") == 0);
  plot.paths[0].points = {{0, 0, -1}, {-0.1, 0, -1}, {-0.1, -0.1, -1}};
  CHECK(count(to_svg(plot), "stroke-opacity") == 1);
}

TEST_CASE("an ellipsoid without extent is said to be none", "[plot]") {
  EllipsoidPlot plot{"p", {1, 0, 1}, {"1", "2", "3"}, {}};
  CHECK(to_svg(plot).find("not positive and finite") != std::string::npos);
}

}  // namespace
}  // namespace rigor
