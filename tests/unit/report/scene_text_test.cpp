// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/scene_text.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "report/data/scene_json.h"
#include "report/picture/scene_plot.h"

namespace rigor {
namespace {

SceneResult example() {
  SceneResult result;
  result.title = "A spin";
  result.body = "cross";
  const Dimension moment = Dimension::of(BaseQuantity::mass) + Dimension::of(BaseQuantity::length) * 2;
  const Dimension rate = Dimension::of(BaseQuantity::time) * -1;
  result.quantities.push_back({"T_{rot}", 0, {162.5}, {1e-14}, moment + rate + rate});
  result.quantities.push_back({"I_{ij}", 2, {10, 0, 0, 0, 20, -0.0, 0, 0, 26}, {}, moment});
  result.quantities.push_back({"\\mathbf{L}(t)", 1, {1, 2, 3}, {}, moment + rate, {{1, 2, 3}, {2, 1, 3}}});
  result.motion = Motion{{0, 0.5}, {{1, 0, 0}, {0, 1, 0}}, {{1, 0, 0, 0}, {1, 0, 0, 0}}, 7, 91, ""};
  result.drifts.push_back({"\\mathbf{L}(t)", 2e-13, true, true});
  result.nodes = {{"particles", true, "read", 0.25}, {"principal axes", false, "nothing needs it", 0}};
  return result;
}

TEST_CASE("a scene is printed with units, rows and what stayed constant", "[scene]") {
  CHECK(print_scene(example()) ==
        "A spin\n"
        "  body                    cross\n"
        "  T_{rot}                 162.5 kg m^2/s^2\n"
        "                          rounding errors are at most 1.0e-14\n"
        "  I_{ij}                  (10, 0, 0) kg m^2\n"
        "                          (0, 20, 0)\n"
        "                          (0, 0, 26)\n"
        "  \\mathbf{L}(t)           (1, 2, 3) kg m^2/s\n"
        "      t = 0.5 s           (2, 1, 3)\n"
        "\n"
        "motion: 2 rows until 0.5 s, 7 steps, 91 evaluations of the rates\n"
        "  \\mathbf{L}(t)           constant in space to 2.0e-13\n");
}

TEST_CASE("of split steps the measured order is printed", "[scene]") {
  SceneResult result = example();
  result.motion->split_order = 1.996;
  CHECK(print_scene(result).find("7 steps (split, of order 2.00), 91 evaluations") != std::string::npos);
}

TEST_CASE("a bound is rounded up, stands beside all digits, and none is printed where none is known") {
  SceneResult result = example();
  result.quantities[0].value = {162.0 + 1 / 3.0};
  result.quantities[0].error = {1.6400001e-13};
  CHECK(print_scene(result).find("162.33333333333334 kg m^2/s^2\n"
                                 "                          rounding errors are at most 1.7e-13\n") !=
        std::string::npos);
  result.quantities[0].error = {std::numeric_limits<double>::infinity()};
  CHECK(print_scene(result).find("no bound of the rounding errors is known\n") != std::string::npos);
  result.quantities[0].error = {9.96e-5};
  CHECK(print_scene(result).find("at most 1.0e-04\n") != std::string::npos);
  result.quantities[0].error = {0};
  CHECK(print_scene(result).find("                          exactly\n") != std::string::npos);
}

TEST_CASE("where the bound leaves open on which side of 0 a scalar is, that is said", "[scene]") {
  constexpr const char* open = "its sign cannot be told from these numbers\n";
  SceneResult result = example();
  result.quantities[0].value = {-1e-14};
  result.quantities[0].error = {1e-14};
  CHECK(print_scene(result).find("at most 1.0e-14: its sign cannot be told from these numbers\n") !=
        std::string::npos);
  result.quantities[0].value = {-1.1e-14};
  CHECK(print_scene(result).find(open) == std::string::npos);
  result.quantities[0].value = {0};
  result.quantities[0].error = {0};
  CHECK(print_scene(result).find(open) == std::string::npos);
}

TEST_CASE("what was computed and what not is printed where it is asked for", "[scene]") {
  const std::string text = print_scene(example(), {.explain = true});
  CHECK(text.find("computed\n  particles                               0.2500 ms  read\n"
                  "not computed\n  principal axes                      nothing needs it\n"
                  "1 computed, 1 not; 0.2500 ms\n") != std::string::npos);
}

TEST_CASE("a scene's JSON has every number and null for what is none", "[scene]") {
  SceneResult result = example();
  result.quantities[0].value[0] = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(to_json(result, SourceMap()));
  CHECK(json["quantities"][0]["value"][0].is_null());
  CHECK(json["quantities"][1]["unit"] == "kg m^2");
  CHECK(json["quantities"][2]["rows"][1][0] == 2);
  CHECK(json["motion"]["stopped"].is_null());
  CHECK(json["computed"] == 1);
  CHECK(json["nodes"][1]["reason"] == "nothing needs it");
}

TEST_CASE("a scene is drawn with one plot for each quantity over the time", "[scene]") {
  const auto plots = plots_of(example());
  REQUIRE(plots.size() == 1);
  CHECK(plots[0].series.size() == 3);
  CHECK(plots[0].series[1].points[1].y == 1);
  CHECK(plots[0].y.label == "$\\mathbf{L}$ (kg m$^2$/s)");
}

TEST_CASE("the path of the spin lies on an ellipsoid only where the moments are known", "[scene]") {
  SceneResult result = example();
  CHECK(spin_paths_of(result).empty());
  result.moments = Vector3{4, 1, 0.25};
  result.motion->spins[1] = {0, 2, 0};
  REQUIRE(spin_paths_of(result).size() == 1);
  CHECK(spin_paths_of(result)[0].half_axes == std::array<double, 3>{1, 2, 4});
  result.moments = Vector3{4, 1, 0};
  CHECK(spin_paths_of(result).empty());
}

TEST_CASE("a spin that leaves the ellipsoid, as with a torque, has no path on it", "[scene]") {
  SceneResult result = example();
  result.moments = Vector3{4, 1, 0.25};
  result.motion->spins[1] = {0, 2 * (1 + 4e-7), 0};
  CHECK(spin_paths_of(result).size() == 1);
  result.motion->spins[1] = {0, 2 * (1 + 6e-7), 0};
  CHECK(spin_paths_of(result).empty());
  result.motion->spins[1] = {0, std::nan(""), 0};
  CHECK(spin_paths_of(result).empty());
}

TEST_CASE("a quantity that is not finite all the time is not said to change", "[scene]") {
  SceneResult result = example();
  result.drifts[0] = {"\\mathbf{L}(t)", std::nan(""), false, false};
  CHECK(print_scene(result).find("  \\mathbf{L}(t)           is not finite all the time\n") !=
        std::string::npos);
}

}  // namespace
}  // namespace rigor
