// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "report/page/page_parts.h"

namespace rigor {
namespace {

using Palette = std::map<std::string, std::uint32_t, std::less<>>;  // 0xRRGGBB

/// The colours of the `:root` block that comes first after `from`, on top of others.
Palette palette_after(std::string_view style, std::size_t from, Palette colours = {}) {
  const std::size_t end = style.find('}', style.find(":root {", from));
  for (std::size_t at = style.find("--", style.find(":root {", from)); at < end;
       at = style.find("--", at + 2)) {
    const std::size_t colon = style.find(':', at);
    std::string hex(style.substr(colon + 3, style.find(';', colon) - colon - 3));
    if (hex.size() == 3) hex = {hex[0], hex[0], hex[1], hex[1], hex[2], hex[2]};
    colours[std::string(style.substr(at + 2, colon - at - 2))] =
        static_cast<std::uint32_t>(std::stoul(hex, nullptr, 16));
  }
  return colours;
}

/// Relative luminance as WCAG 2 defines it.
double luminance(std::uint32_t colour) {
  const auto linear = [&](unsigned shift) {
    const double share = static_cast<double>((colour >> shift) & 0xFFU) / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(16) + 0.7152 * linear(8) + 0.0722 * linear(0);
}

double contrast(std::uint32_t a, std::uint32_t b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

}  // namespace

TEST_CASE("black on white has the contrast that WCAG says") {
  CHECK(contrast(0x000000, 0xFFFFFF) == Approx(21));
  CHECK(contrast(0x777777, 0xFFFFFF) == Approx(4.478).epsilon(0.001));
}

TEST_CASE("every text of the page has a contrast of at least 4.5 in light, in dark and in print") {
  const std::string_view style = page_style();
  const Palette light = palette_after(style, 0);
  const Palette dark = palette_after(style, style.find("prefers-color-scheme: dark"), light);
  const Palette print = palette_after(style, style.find("@media print"), light);
  REQUIRE(light.size() == 15);
  REQUIRE(dark.at("ground") != light.at("ground"));
  const std::map<std::string, std::vector<std::string>> texts{
      {"ground", {"ink", "soft", "link", "proved", "refuted", "given", "definition", "open"}},
      {"card", {"ink", "soft", "link", "proved", "refuted", "given", "definition", "open"}},
      {"wash", {"ink", "soft", "link", "proved", "refuted", "given", "definition", "open"}},
      {"attention-wash", {"ink", "soft", "link", "proved", "refuted"}},
      {"open-wash", {"ink", "soft", "link", "open"}}};
  for (const Palette* palette : {&light, &dark, &print}) {
    for (const auto& [ground, inks] : texts) {
      for (const std::string& ink : inks) {
        INFO((palette == &light  ? "light"
              : palette == &dark ? "dark"
                                 : "print")
             << ": " << ink << " on " << ground);
        CHECK(contrast(palette->at(ink), palette->at(ground)) >= 4.5);
      }
    }
  }
}

}  // namespace rigor
