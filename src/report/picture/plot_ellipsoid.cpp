// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/plot_ellipsoid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/picture/svg.h"
#include "report/picture/svg_label.h"

namespace rigor {
namespace {

using Vector = std::array<double, 3>;

constexpr double side = 560;  // width
constexpr double height = 470;
constexpr double ellipsoid_title = 44;
constexpr double legend_row = 22;
constexpr double radius = 190;  // of the largest half axis
constexpr std::array<std::string_view, 5> axis_colours{"#c4472b", "#16325c", "#3f8f5f", "#d9a21b", "#8a5fb0"};
constexpr std::array<std::string_view, 5> dashes{"", "7 4", "2 3.5", "10 3 2 3", "1 3"};

/// One picture while it is drawn; lengths in units of the largest half axis.
class Drawing {
 public:
  explicit Drawing(const EllipsoidPlot& plot)
      : plot_(plot),
        rows_(static_cast<double>(plot.paths.size())),
        svg_(side, ellipsoid_title + height + rows_ * legend_row, plot.title) {
    unit_ = std::ranges::max(plot.half_axes);
  }

  std::string draw() {
    svg_.text({side / 2, 28}, svg_label(plot_.title),
              {.size = 15, .anchor = SvgAnchor::middle, .bold = true});
    const bool drawable =
        std::ranges::all_of(plot_.half_axes, [](double half) { return half > 0 && std::isfinite(half); });
    if (!drawable) {
      svg_.text({side / 2, height / 2}, "an axis of the ellipsoid is not positive and finite",
                {.anchor = SvgAnchor::middle});
      return svg_.finish();
    }
    draw_wires();
    draw_outline();
    draw_axes();
    for (std::size_t i = 0; i < plot_.paths.size(); ++i) draw_path(i);
    return svg_.finish();
  }

 private:
  /// From (1, 1, 1), the third axis upwards: x to the lower left, y to the lower right.
  [[nodiscard]] SvgPoint project(const Vector& point) const {
    const double x = point[0] / unit_;
    const double y = point[1] / unit_;
    const double z = point[2] / unit_;
    const double across = (y - x) / std::numbers::sqrt2;
    const double up = (2 * z - x - y) / std::sqrt(6.0);
    return {side / 2 + radius * across, ellipsoid_title + height * 0.47 - radius * up};
  }

  /// Is the surface at this point turned towards the eye? Its normal is (x/a², y/b², z/c²).
  [[nodiscard]] bool in_front(const Vector& point) const {
    double facing = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double half = plot_.half_axes[i] / unit_;
      facing += point[i] / unit_ / (half * half);
    }
    return facing >= 0;
  }

  /// Both sides of a curve, each in its own stroke; the far side first.
  void curve(const std::vector<Vector>& points, const SvgStroke& front, const SvgStroke& back) {
    for (const bool wanted : {false, true}) {
      std::vector<SvgPoint> run;
      for (const Vector& point : points) {
        const bool finite =
            std::ranges::all_of(point, [&](double each) { return std::abs(each) < 1e3 * unit_; });
        if (finite && (in_front(point) == wanted || !run.empty())) run.push_back(project(point));
        if (!finite || in_front(point) != wanted) {
          svg_.polyline(run, wanted ? front : back);
          run.clear();
        }
      }
      svg_.polyline(run, wanted ? front : back);
    }
  }

  void draw_wires() {
    const SvgStroke front{"#8f9bb0", 0.7};
    const SvgStroke back{"#d3d8e0", 0.6};
    constexpr int fine = 96;
    const auto [a, b, c] = plot_.half_axes;
    for (int k = -4; k <= 4; ++k) {  // circles of latitude, 18° apart
      const double latitude = k * std::numbers::pi / 10;
      std::vector<Vector> ring;
      for (int i = 0; i <= fine; ++i) {
        const double longitude = 2 * std::numbers::pi * i / fine;
        ring.push_back({a * std::cos(latitude) * std::cos(longitude),
                        b * std::cos(latitude) * std::sin(longitude), c * std::sin(latitude)});
      }
      curve(ring, front, back);
    }
    for (int k = 0; k < 20; ++k) {  // half circles of longitude, 18° apart
      const double longitude = k * std::numbers::pi / 10;
      std::vector<Vector> arc;
      for (int i = 0; i <= fine / 2; ++i) {
        const double latitude = std::numbers::pi * (2.0 * i / fine - 0.5);
        arc.push_back({a * std::cos(latitude) * std::cos(longitude),
                       b * std::cos(latitude) * std::sin(longitude), c * std::sin(latitude)});
      }
      curve(arc, front, back);
    }
  }

  /// Where the surface turns away from the eye: with p = (a u, b v, c w) and (u, v, w) on the unit sphere,
  /// u/a + v/b + w/c = 0, a great circle at right angles to (1/a, 1/b, 1/c).
  void draw_outline() {
    const auto& half = plot_.half_axes;
    const Vector normal{unit_ / half[0], unit_ / half[1], unit_ / half[2]};
    const double flat = std::hypot(normal[0], normal[1]);
    const double full = std::hypot(flat, normal[2]);
    const Vector first{-normal[1] / flat, normal[0] / flat, 0};
    const Vector second{-normal[0] * normal[2] / (flat * full), -normal[1] * normal[2] / (flat * full),
                        flat / full};
    std::vector<SvgPoint> outline;
    constexpr int fine = 120;
    for (int k = 0; k <= fine; ++k) {
      const double angle = 2 * std::numbers::pi * k / fine;
      Vector point{};
      for (std::size_t i = 0; i < 3; ++i) {
        point[i] = half[i] * (std::cos(angle) * first[i] + std::sin(angle) * second[i]);
      }
      outline.push_back(project(point));
    }
    svg_.polyline(outline, {"#5d6a82", 1.2});
  }

  void draw_axes() {
    for (std::size_t i = 0; i < 3; ++i) {
      Vector from{};
      Vector to{};
      from[i] = plot_.half_axes[i];
      to[i] = plot_.half_axes[i] + 0.3 * unit_;
      svg_.line(project(from), project(to), {"#444444", 1.1});
      Vector beyond{};
      beyond[i] = to[i] + 0.09 * unit_;
      const SvgPoint end = project(beyond);
      svg_.text({end.x, end.y + 5}, svg_label(plot_.names[i]), {.size = 15, .anchor = SvgAnchor::middle});
    }
  }

  void draw_path(std::size_t position) {
    const EllipsoidPath& path = plot_.paths[position];
    const std::string_view colour = axis_colours[position % axis_colours.size()];
    const std::string_view dash = dashes[position % dashes.size()];
    curve(path.points, {colour, 2.4, dash}, {colour, 1.2, dash, 0.45});
    const double y = ellipsoid_title + height + legend_row * static_cast<double>(position) - 4;
    svg_.line({40, y}, {76, y}, {colour, 2.4, dash});
    svg_.text({86, y + 4.5}, svg_label(path.name), {});
  }

  const EllipsoidPlot& plot_;
  double rows_;
  double unit_ = 1;  // the largest half axis
  Svg svg_;
};

}  // namespace

std::string to_svg(const EllipsoidPlot& plot) { return Drawing(plot).draw(); }

}  // namespace rigor
