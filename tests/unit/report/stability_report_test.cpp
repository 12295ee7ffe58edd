// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/stability_report.h"

#include <cmath>

#include "catch.h"

namespace rigor {
namespace {

std::vector<BodyStability> example() {
  StabilityMeasurement grows;
  grows.axis = 1;
  grows.fate = SpinFate::grows;
  grows.predicted = -5;
  grows.points = {{0.1, -4.9, 0.02}, {0.01, -4.999, 2e-4}};
  grows.order = 2;
  StabilityMeasurement neither;
  neither.predicted = -0.0;
  neither.points = {{0.1, 0, 0}, {0.01, std::nan(""), std::nan("")}};
  neither.order = std::nan("");
  BodyStability none{.body = "rod", .axes = {}, .diagnostics = {{DiagnosticKind::bad_scene, {}, "no | law"}}};
  return {{"box", {grows, neither}, {}}, none};
}

TEST_CASE("a table of stability has a row for each axis, and says what could not be measured",
          "[stability]") {
  const std::string table = stability_table(example());
  CHECK(table.find("| box | 2 | grows | -5 | -4.999 | 2.0e-04 | 2.00 |\n") != std::string::npos);
  CHECK(table.find("| box | 1 | neither | 0 | none | nan | exact |\n") != std::string::npos);
  CHECK(table.find("| rod | | no \\| law | | | | |\n") != std::string::npos);
}

TEST_CASE("the picture of stability has a series for each kind of motion and a line of slope 2",
          "[stability]") {
  const Plot plot = stability_plot(example());
  REQUIRE(plot.series.size() == 3);
  CHECK(plot.series[0].name == "grows");
  const auto& line = plot.series[2].points;
  CHECK(std::log(line[1].y / line[0].y) / std::log(line[1].x / line[0].x) == Approx(2));
  CHECK(to_svg(plot).find("nan") == std::string::npos);
}

}  // namespace
}  // namespace rigor
