// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/svg.h"

#include <fmt/format.h>

#include <cmath>

#include "base/check.h"
#include "base/xml.h"

namespace rigor {
namespace {

std::string stroke_text(const SvgStroke& stroke) {
  std::string text =
      fmt::format("stroke=\"{}\" stroke-width=\"{}\"", stroke.colour, svg_number(stroke.width));
  if (!stroke.dashes.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes);
  if (stroke.opacity < 1) text += fmt::format(" stroke-opacity=\"{}\"", svg_number(stroke.opacity));
  return text;
}

std::string points_text(std::span<const SvgPoint> points) {
  std::string text;
  for (const SvgPoint& point : points) {
    if (!text.empty()) text += ' ';
    text += svg_number(point.x) + ',' + svg_number(point.y);
  }
  return text;
}

std::string_view anchor_text(SvgAnchor anchor) {
  switch (anchor) {
    case SvgAnchor::start:
      return "start";
    case SvgAnchor::middle:
      return "middle";
    case SvgAnchor::end:
      return "end";
  }
  return "start";
}

}  // namespace

std::string svg_number(double value) {
  RIGOR_CHECK(std::isfinite(value), value);
  std::string text = fmt::format("{:.2f}", value);
  return text == "-0.00" ? "0.00" : text;
}

Svg::Svg(double width, double height, std::string_view title) {
  head_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\" font-family=\"'DejaVu Sans', 'Helvetica Neue', Arial, "
      "sans-serif\">\n<title>{2}</title>\n",
      svg_number(width), svg_number(height), xml_escaped(title));
  body_ = fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", svg_number(width),
                      svg_number(height));
}

void Svg::line(SvgPoint from, SvgPoint to, const SvgStroke& stroke) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", svg_number(from.x),
                       svg_number(from.y), svg_number(to.x), svg_number(to.y), stroke_text(stroke));
}

void Svg::polyline(std::span<const SvgPoint> points, const SvgStroke& stroke) {
  if (points.size() < 2) return;
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n",
                       points_text(points), stroke_text(stroke));
}

void Svg::polygon(std::span<const SvgPoint> corners, std::string_view fill, const SvgStroke& stroke) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" {}/>\n", points_text(corners), fill,
                       stroke_text(stroke));
}

void Svg::circle(SvgPoint centre, double radius, std::string_view fill, const SvgStroke& stroke) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" {}/>\n", svg_number(centre.x),
                       svg_number(centre.y), svg_number(radius), fill, stroke_text(stroke));
}

void Svg::rectangle(SvgPoint corner, double width, double height, std::string_view fill,
                    const SvgStroke& stroke) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" {}/>\n",
                       svg_number(corner.x), svg_number(corner.y), svg_number(width), svg_number(height),
                       fill, stroke_text(stroke));
}

void Svg::text(SvgPoint at, std::string_view markup, const SvgText& style) {
  const std::string x = svg_number(at.x);
  const std::string y = svg_number(at.y);
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"", x, y,
                       svg_number(style.size), anchor_text(style.anchor), style.colour);
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.upwards) body_ += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
  body_ += '>';
  body_ += markup;
  body_ += "</text>\n";
}

void Svg::begin_clip(SvgPoint corner, double width, double height) {
  ++clips_;
  body_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
      "<g clip-path=\"url(#clip{0})\">\n",
      clips_, svg_number(corner.x), svg_number(corner.y), svg_number(width), svg_number(height));
}

void Svg::end_clip() { body_ += "</g>\n"; }

std::string Svg::finish() const { return head_ + body_ + "</svg>\n"; }

}  // namespace rigor
