// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/plot_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "report/picture/plot_scale.h"
#include "report/picture/svg_label.h"

namespace rigor {
namespace {

constexpr double left_margin = 84;
constexpr double right_margin = 26;
constexpr double frame_height = 320;
constexpr double title_height = 40;
constexpr double panel_legend_row = 22;
constexpr double foot_height = 62;
constexpr double letter = 7.6;  // width of one, at size 13

/// Dark blue, vermilion, green, ochre, purple: of different lightness, so that grey shows them apart.
constexpr std::array<std::string_view, 5> palette{"#16325c", "#c4472b", "#3f8f5f", "#d9a21b", "#8a5fb0"};
constexpr std::string_view ink = "#222222";
constexpr std::string_view faint = "#e4e4e4";
constexpr std::string_view grey = "#777777";

std::string_view colour_of(const PlotSeries& series, std::size_t position) {
  const std::size_t chosen = series.colour >= 0 ? static_cast<std::size_t>(series.colour) : position;
  return palette[chosen % palette.size()];
}

SvgStroke stroke_of(const PlotSeries& series, std::string_view colour) {
  const std::string_view dashes = series.stroke == Stroke::dashed   ? "7 4"
                                  : series.stroke == Stroke::dotted ? "2 3.5"
                                                                    : "";
  return {colour, 1.8, dashes};
}

struct LegendEntry {
  std::size_t series = 0;
  double x = 0;
  std::size_t row = 0;
};

std::vector<LegendEntry> legend_of(const Plot& plot) {
  std::vector<LegendEntry> entries;
  double x = left_margin;
  std::size_t row = 0;
  for (std::size_t position = 0; position < plot.series.size(); ++position) {
    if (plot.series[position].name.empty()) continue;
    const double width = 44 + letter * svg_label_letters(plot.series[position].name) + 16;
    if (x > left_margin && x + width > plot_width - right_margin) {
      x = left_margin;
      ++row;
    }
    entries.push_back({position, x, row});
    x += width;
  }
  return entries;
}

double legend_height(const Plot& plot) {
  const std::vector<LegendEntry> entries = legend_of(plot);
  return entries.empty() ? 0 : panel_legend_row * static_cast<double>(entries.back().row + 1) + 4;
}

struct PlotBox {
  double left, top, right, bottom;
  [[nodiscard]] bool meets(const PlotBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// One plot while it is drawn.
class Panel {
 public:
  Panel(Svg& svg, const Plot& plot, double top)
      : svg_(svg), plot_(plot), top_(top), frame_top_(top + title_height + legend_height(plot)) {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const PlotSeries& series : plot.series) {
      for (const PlotPoint& point : series.points) {
        xs.push_back(point.x);
        ys.push_back(point.y);
      }
    }
    x_ = fitting_scale(xs, plot.x.logarithmic);
    y_ = fitting_scale(ys, plot.y.logarithmic);
    if (!plot.x.logarithmic) tighten(xs);
  }

  void draw() {
    svg_.text({plot_width / 2, top_ + 26}, svg_label(plot_.title),
              {.size = 15, .anchor = SvgAnchor::middle, .bold = true});
    draw_legend();
    draw_axes();
    svg_.begin_clip({left_margin, frame_top_ - 8}, frame_width, frame_height + 16);
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_curve(plot_.series[i], i);
    svg_.end_clip();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_points(plot_.series[i], i);
    for (const PlotSeries& series : plot_.series) draw_labels(series);
    if (at_infinity_) edge_name("∞", frame_top_ + 5);
    if (at_zero_) edge_name("0", frame_top_ + frame_height + 4);
  }

 private:
  static constexpr double frame_width = plot_width - left_margin - right_margin;

  /// Curves begin and end at the frame: a linear horizontal axis needs no room at its ends.
  void tighten(const std::vector<double>& xs) {
    for (const PlotSeries& series : plot_.series) {
      if (series.mark != Mark::none) return;
    }
    double low = INFINITY;
    double high = -INFINITY;
    for (const double x : xs) {
      if (!std::isfinite(x)) continue;
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (low < high && low >= x_.low && high <= x_.high) {
      x_.low = low;
      x_.high = high;
    }
  }

  /// 0 to 1 on the scale, or beyond an edge; nothing where there is no place.
  static std::optional<double> place(const PlotScale& scale, double value) {
    if (std::isnan(value)) return std::nullopt;
    if (value == INFINITY) return 1.0;
    if (scale.logarithmic && value == 0) return 0.0;
    if (!std::isfinite(value) || (scale.logarithmic && value < 0)) return std::nullopt;
    return std::clamp(scale.place(value), -1.0, 2.0);
  }

  std::optional<SvgPoint> at(const PlotPoint& point) {
    const auto x = place(x_, point.x);
    const auto y = place(y_, point.y);
    if (!x || !y) return std::nullopt;
    at_infinity_ = at_infinity_ || point.y == INFINITY;
    at_zero_ = at_zero_ || (y_.logarithmic && point.y == 0);
    return SvgPoint{left_margin + *x * frame_width, frame_top_ + (1 - *y) * frame_height};
  }

  void draw_legend() {
    for (const LegendEntry& entry : legend_of(plot_)) {
      const PlotSeries& series = plot_.series[entry.series];
      const std::string_view colour = colour_of(series, entry.series);
      const double y = top_ + title_height + 10 + panel_legend_row * static_cast<double>(entry.row);
      if (series.stroke != Stroke::none) {
        svg_.line({entry.x, y}, {entry.x + 34, y}, stroke_of(series, colour));
      }
      draw_mark(svg_, series.mark, {entry.x + 17, y}, colour);
      svg_.text({entry.x + 42, y + 4.5}, svg_label(series.name), {});
    }
  }

  void draw_axes() {
    const double bottom = frame_top_ + frame_height;
    for (const Tick& tick : ticks_of(x_)) {
      const double x = left_margin + x_.place(tick.value) * frame_width;
      svg_.line({x, frame_top_}, {x, bottom}, {.colour = faint});
      svg_.line({x, bottom}, {x, bottom + 5}, {.colour = ink});
      if (!tick.label.empty()) {
        svg_.text({x, bottom + 20}, svg_label(tick.label), {.size = 12, .anchor = SvgAnchor::middle});
      }
    }
    for (const Tick& tick : ticks_of(y_)) {
      const double y = bottom - y_.place(tick.value) * frame_height;
      svg_.line({left_margin, y}, {left_margin + frame_width, y}, {.colour = faint});
      svg_.line({left_margin - 5, y}, {left_margin, y}, {.colour = ink});
      if (!tick.label.empty()) {
        svg_.text({left_margin - 9, y + 4}, svg_label(tick.label), {.size = 12, .anchor = SvgAnchor::end});
      }
    }
    if (!y_.logarithmic && y_.low < 0 && y_.high > 0) {
      const double y = bottom - y_.place(0) * frame_height;
      svg_.line({left_margin, y}, {left_margin + frame_width, y}, {.colour = "#b0b0b0"});
    }
    svg_.rectangle({left_margin, frame_top_}, frame_width, frame_height, "none", {.colour = ink});
    svg_.text({left_margin + frame_width / 2, bottom + 44}, svg_label(plot_.x.label),
              {.anchor = SvgAnchor::middle});
    svg_.text({22, frame_top_ + frame_height / 2}, svg_label(plot_.y.label),
              {.anchor = SvgAnchor::middle, .upwards = true});
  }

  void draw_curve(const PlotSeries& series, std::size_t position) {
    if (series.stroke == Stroke::none) return;
    const SvgStroke stroke = stroke_of(series, colour_of(series, position));
    std::vector<SvgPoint> run;
    for (const PlotPoint& point : series.points) {
      if (const auto place = at(point)) {
        run.push_back(*place);
      } else {
        svg_.polyline(run, stroke);
        run.clear();
      }
    }
    svg_.polyline(run, stroke);
  }

  void draw_points(const PlotSeries& series, std::size_t position) {
    if (series.mark == Mark::none) return;
    for (const PlotPoint& point : series.points) {
      const auto place = at(point);
      if (!place) continue;
      draw_mark(svg_, series.mark, *place, colour_of(series, position));
      taken_.push_back({place->x - 5, place->y - 5, place->x + 5, place->y + 5});
    }
  }

  /// To the right of its point, or wherever there is room around it.
  void draw_labels(const PlotSeries& series) {
    for (const PlotPoint& point : series.points) {
      const auto place = at(point);
      if (!place || point.label.empty()) continue;
      const double width = letter * 0.85 * svg_label_letters(point.label);
      const std::array<SvgPoint, 6> corners{{{place->x + 9, place->y - 7},
                                             {place->x - 9 - width, place->y - 7},
                                             {place->x - width / 2, place->y - 21},
                                             {place->x - width / 2, place->y + 8},
                                             {place->x + 9, place->y - 20},
                                             {place->x + 9, place->y + 6}}};
      SvgPoint chosen = corners[0];
      for (const SvgPoint& corner : corners) {
        if (fits({corner.x, corner.y, corner.x + width, corner.y + 14})) {
          chosen = corner;
          break;
        }
      }
      taken_.push_back({chosen.x, chosen.y, chosen.x + width, chosen.y + 14});
      svg_.text({chosen.x, chosen.y + 11}, svg_label(point.label), {.size = 11.5, .colour = "#333333"});
    }
  }

  [[nodiscard]] bool fits(const PlotBox& box) const {
    if (box.left < left_margin || box.right > left_margin + frame_width) return false;
    if (box.top < frame_top_ || box.bottom > frame_top_ + frame_height) return false;
    return std::ranges::none_of(taken_, [&](const PlotBox& other) { return box.meets(other); });
  }

  void edge_name(std::string_view name, double y) {
    svg_.text({left_margin + frame_width + 8, y}, name, {.size = 14, .colour = grey});
  }

  Svg& svg_;
  const Plot& plot_;
  double top_;
  double frame_top_;
  PlotScale x_;
  PlotScale y_;
  std::vector<PlotBox> taken_;
  bool at_infinity_ = false;
  bool at_zero_ = false;
};

}  // namespace

double plot_height(const Plot& plot) {
  return title_height + legend_height(plot) + frame_height + foot_height;
}

void draw_plot(Svg& svg, const Plot& plot, double top) { Panel(svg, plot, top).draw(); }

void draw_mark(Svg& svg, Mark mark, SvgPoint centre, std::string_view colour) {
  constexpr double size = 4.5;
  const auto [x, y] = centre;
  const SvgStroke edge{"#ffffff", 0.8};
  switch (mark) {
    case Mark::none:
      return;
    case Mark::circle:
      svg.circle(centre, size, colour, edge);
      return;
    case Mark::square:
      svg.rectangle({x - size * 0.9, y - size * 0.9}, size * 1.8, size * 1.8, colour, edge);
      return;
    case Mark::triangle:
    case Mark::triangle_down: {
      const double up = mark == Mark::triangle ? -size : size;
      const std::array<SvgPoint, 3> corners{
          {{x, y + up * 1.2}, {x + size * 1.1, y - up * 0.8}, {x - size * 1.1, y - up * 0.8}}};
      svg.polygon(corners, colour, edge);
      return;
    }
    case Mark::diamond: {
      const std::array<SvgPoint, 4> corners{
          {{x, y - size * 1.3}, {x + size * 1.3, y}, {x, y + size * 1.3}, {x - size * 1.3, y}}};
      svg.polygon(corners, colour, edge);
      return;
    }
    case Mark::ring:
      svg.circle(centre, size, "none", {colour, 2});
      return;
    case Mark::cross:
    case Mark::plus:
    case Mark::star:
      if (mark != Mark::plus) {
        svg.line({x - size, y - size}, {x + size, y + size}, {colour, 2});
        svg.line({x - size, y + size}, {x + size, y - size}, {colour, 2});
      }
      if (mark != Mark::cross) {
        svg.line({x - size * 1.3, y}, {x + size * 1.3, y}, {colour, 2});
        svg.line({x, y - size * 1.3}, {x, y + size * 1.3}, {colour, 2});
      }
      return;
  }
}

}  // namespace rigor
