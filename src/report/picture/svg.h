// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing as SVG 1.1 in one file: no script, nothing from the network. The same calls give the same bytes:
// lengths have two digits after the point. Lengths are pixels, y points down.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rigor {

struct SvgPoint {
  double x = 0;
  double y = 0;
};

enum class SvgAnchor : std::uint8_t { start, middle, end };

/// How a line is drawn; `dashes` as SVG has them (`6 3`), empty for a solid one.
struct SvgStroke {
  std::string_view colour = "#222222";
  double width = 1;
  std::string_view dashes = {};
  double opacity = 1;
};

struct SvgText {
  double size = 13;
  SvgAnchor anchor = SvgAnchor::start;
  std::string_view colour = "#222222";
  bool bold = false;
  bool upwards = false;  // turned by a quarter, read from below
};

class Svg {
 public:
  /// On a white ground, so that it can be read on any page. `title` is what a screen reader says.
  Svg(double width, double height, std::string_view title);

  void line(SvgPoint from, SvgPoint to, const SvgStroke& stroke);
  /// Nothing for fewer than two points. Points that are not finite are our own bug.
  void polyline(std::span<const SvgPoint> points, const SvgStroke& stroke);
  void polygon(std::span<const SvgPoint> corners, std::string_view fill, const SvgStroke& stroke);
  void circle(SvgPoint centre, double radius, std::string_view fill, const SvgStroke& stroke);
  void rectangle(SvgPoint corner, double width, double height, std::string_view fill,
                 const SvgStroke& stroke);
  /// `markup` is what `svg_label` or `xml_escaped` made.
  void text(SvgPoint at, std::string_view markup, const SvgText& style);
  /// What follows is cut off outside the rectangle, until `end_clip`.
  void begin_clip(SvgPoint corner, double width, double height);
  void end_clip();

  /// The file; it ends with a line break.
  [[nodiscard]] std::string finish() const;

 private:
  std::string head_;
  std::string body_;
  int clips_ = 0;
};

/// `12.50`: two digits, never `-0.00`.
[[nodiscard]] std::string svg_number(double value);

}  // namespace rigor
