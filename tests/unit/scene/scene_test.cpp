// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "catch.h"
#include "expr/build.h"
#include "numeric/body/bodies.h"
#include "numeric/body/shapes.h"
#include "peak_memory.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

TEST_CASE("a scene that asks for the energy alone touches neither moments, axes nor motion", "[scene]") {
  const Played played("spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}']\n", sample());
  CHECK(played.messages() == "");
  CHECK(played.value("T_{rot}") == (10 + 4 * 20 + 9 * 26) / 2.0);
  CHECK(played.computed("particles"));
  CHECK(played.computed("T_{rot}"));
  CHECK(played.result.counts().computed == 2);
  CHECK(played.result.counts().skipped == 7);
}

TEST_CASE("a stability frequency needs principal moments and no axes", "[scene]") {
  const Played played("spin = [1, 2, 3]\nat = \"A thrown racket\"\n[ask]\nquantities = ['(\\Omega_2)^2']\n",
                      sample());
  CHECK(played.messages() == "");
  CHECK(played.value("(\\Omega_2)^2") == Approx((10 - 20) * (26 - 20) / (26.0 * 10) * 4).epsilon(1e-14));
  CHECK(played.computed("principal moments"));
  CHECK(!played.computed("principal axes"));
  CHECK(!played.computed("particles"));
  CHECK(!played.computed("motion"));
  CHECK(played.result.counts().computed == 3);  // the tensor to 100 bits came with the points
}

TEST_CASE("a stability frequency keeps its digits where two moments are alike in twelve", "[scene]") {
  const double x = 1 + 0x1p-42;
  // I_2 − I_1 = 2 (x² − 1) and I_3 − I_2 = 2 (1 − z²), exactly.
  const double z = 0.5;
  const double lower = 2 * (x - 1) * (x + 1);
  const double exact = -lower * (2 - 2 * z * z) / ((2 * x * x + 2) * (2 + 2 * z * z)) * 4;
  for (const bool shifted : {false, true}) {
    Body body = cross_of_masses(x, 1, z);
    for (auto& coordinates : body.positions)
      for (double& each : coordinates) each += shifted ? 0.125 : 0;
    const Played played("spin = [1, 2, 3]\nat = \"A thrown racket\"\n[ask]\nquantities = ['(\\Omega_2)^2']\n",
                        body);
    CHECK(std::abs(played.value("(\\Omega_2)^2") / exact - 1) <= 16 * 0x1p-53);
  }
}

TEST_CASE("a body that is given by its moments has exactly these", "[scene]") {
  const Body given = *body_with_inertia("given", 1, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 2 + 0x1p-40}}});
  const Played played(
      "spin = [1, 0, 0]\nat = \"A thrown racket\"\n[ask]\nerrors = true\nquantities = ['principal moments', "
      "'(\\Omega_1)^2', '(\\Omega_3)^2']\n",
      given);
  CHECK(played.messages() == "");
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(played.value("principal moments", i) == given.known->inertia[i][i]);
  const double exact = (1 + 0x1p-40) * 1 / (2 * (2 + 0x1p-40));
  CHECK(std::abs(played.value("(\\Omega_1)^2") - exact) <= 8 * 0x1p-53 * exact);
}

TEST_CASE("a shape's moments are as good as its formula, also where two are nearly alike", "[scene]") {
  const double radius = 1 + 0x1p-36;
  const Body round = *quadrature_body("round", {ShapeKind::ellipsoid, 1, {radius, 1, 0.5}});
  const Played played(
      "spin = [1, 1, 2]\nat = \"A thrown racket\"\n[ask]\nerrors = true\nquantities = ['(\\Omega_2)^2']\n",
      round);
  // I_1 = (1 + c²)/5, I_2 = (a² + c²)/5, I_3 = (a² + 1)/5.
  const double square = radius * radius;
  const double exact = -(radius - 1) * (radius + 1) * 0.75 / ((square + 1) * 1.25);
  CHECK(std::abs(played.value("(\\Omega_2)^2") / exact - 1) <= 16 * 0x1p-53);
}

TEST_CASE("frequencies of a body that lies askew are as good as those of one that does not", "[scene]") {
  // Two arms in a plane, turned by the angle with the tangent 4/3: every place is a double.
  const double x = 1 + 0x1p-30;
  const double c = 0.625;
  const Body body = *point_masses("askew", {1, 1, 1, 1, 1, 1},
                                  {{3 * c * x, 4 * c * x, 0},
                                   {-3 * c * x, -4 * c * x, 0},
                                   {-4 * c, 3 * c, 0},
                                   {4 * c, -3 * c, 0},
                                   {0, 0, 1},
                                   {0, 0, -1}});
  const double square = 25 * c * c;  // of an arm; I_1 = 2 (B + 1), I_2 = 2 (A + 1), I_3 = 2 (A + B)
  const double gap = 2 * square * (x - 1) * (x + 1);
  const double exact = -gap * 2 * (square - 1) / (2 * (square * x * x + square) * 2 * (square + 1)) * 4;
  const Played played(
      "axes = \"principal\"\nspin = [0, 2, 0]\nat = \"A thrown racket\"\n[ask]\nquantities = "
      "['(\\Omega_2)^2']\n",
      body);
  CHECK(played.messages() == "");
  CHECK(std::abs(played.value("(\\Omega_2)^2") / exact - 1) <= 16 * 0x1p-53);
}

TEST_CASE("moments and axes of the body are found where it does not lie along them", "[scene]") {
  const Played played("[ask]\nquantities = ['principal moments', 'principal axes', 'I_{ij}']\n",
                      turned_cross(3, 2, 1));
  CHECK(played.messages() == "");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(played.value("principal moments", i) == Approx(std::array{10, 20, 26}[i]).epsilon(1e-14));
  }
  CHECK(played.value("principal axes", 0) == Approx(std::sqrt(0.75)).epsilon(1e-14));
  CHECK(played.value("I_{ij}", 1) == Approx((10 - 20) * 0.5 * std::sqrt(0.75)).epsilon(1e-14));
  CHECK(played.value("I_{ij}", 1) == played.value("I_{ij}", 3));
  CHECK(played.computed("principal axes"));
}

TEST_CASE("moments alone are values alone", "[scene]") {
  const Played played("[ask]\nquantities = ['principal moments']\n", turned_cross(3, 2, 1));
  CHECK(played.computed("principal moments"));
  CHECK(!played.computed("principal axes"));
  CHECK(played.value("principal moments", 2) == Approx(26).epsilon(1e-14));
}

TEST_CASE("a spin along principal axes needs no axes, one along the body's does", "[scene]") {
  const std::string ask = std::string(racket) + "spin = [1, 2, 3]\n[ask]\nquantities = ['(\\Omega_2)^2']\n";
  const double expected = (10 - 20) * (26 - 20) / (26.0 * 10) * 4;
  const Played principal("axes = \"principal\"\n" + ask, turned_cross(3, 2, 1));
  CHECK(principal.messages() == "");
  CHECK(principal.value("(\\Omega_2)^2") == Approx(expected).epsilon(1e-13));
  CHECK(!principal.computed("principal axes"));

  const Played body("axes = \"body\"\n" + ask, turned_cross(3, 2, 1));
  CHECK(body.messages() == "");
  const double along = -0.5 * 1 + std::sqrt(0.75) * 2;  // ω along the second principal axis
  CHECK(body.value("(\\Omega_2)^2") == Approx(expected / 4 * along * along).epsilon(1e-13));
  CHECK(body.computed("principal axes"));
}

TEST_CASE("where it is open along which axes a spin is meant, the scene says so", "[scene]") {
  const Played played(std::string(racket) + "spin = [1, 2, 3]\n[ask]\nquantities = ['(\\Omega_2)^2']\n",
                      turned_cross(3, 2, 1));
  CHECK(played.messages() ==
        "bad-scene: principal moments are needed, but the body's axes are not its principal axes\n"
        "help: say with `axes = \"principal\"` or `axes = \"body\"` along which the components are given\n");
}

TEST_CASE("the energy does not depend on the axes along which a turned body is looked at", "[scene]") {
  const std::string ask = "spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}', 'L_i']\n";
  const Played played("axes = \"principal\"\n" + ask, turned_cross(3, 2, 1));
  CHECK(played.messages() == "");
  CHECK(played.value("T_{rot}") == Approx((10 + 4 * 20 + 9 * 26) / 2.0).epsilon(1e-14));
  CHECK(played.value("L_i", 2) == Approx(78).epsilon(1e-14));
  CHECK(played.computed("particles along the principal axes"));
}

TEST_CASE("the notes' own equations move the body and keep energy and angular momentum", "[scene]") {
  const Played played(std::string("spin = [0.01, 5, 0]\n[ask]\nquantities = ['\\boldsymbol{\\omega}(t)', "
                                  "'\\mathbf{L}(t)', 'T_{rot}']\n") +
                          euler,
                      sample());
  CHECK(played.messages() == "");
  REQUIRE(played.result.motion);
  CHECK(played.result.motion->times.size() == 501);
  CHECK(played.computed("law of motion"));
  REQUIRE(played.quantity("\\mathbf{L}(t)").rows.size() == 501);
  CHECK(played.quantity("\\mathbf{L}(t)").rows[0][1] == 100);
  bool turned_over = false;
  for (const auto& row : played.quantity("\\boldsymbol{\\omega}(t)").rows)
    turned_over = turned_over || row[1] < -4.9;
  CHECK(turned_over);
  REQUIRE(played.result.drifts.size() == 3);
  CHECK(!played.result.drifts[0].constant);
  CHECK((played.result.drifts[1].constant && played.result.drifts[1].in_space));
  CHECK((played.result.drifts[2].constant && !played.result.drifts[2].in_space));
  CHECK(played.result.drifts[1].relative < 1e-7);
  CHECK(played.result.drifts[2].relative < 1e-8);
}

TEST_CASE("quantities have their dimensions", "[scene]") {
  const Played played(
      "spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}', 'I_{ij}', '\\mathbf{L}', '\\boldsymbol{\\omega}']\n",
      sample());
  CHECK(played.messages() == "");
  const auto text = [&](const char* source) {
    return played.quantity(source).dimension.value_or(Dimension()).text();
  };
  CHECK(text("T_{rot}") == "M L^2 T^{-2}");
  CHECK(text("I_{ij}") == "M L^2");
  CHECK(text("\\mathbf{L}") == "M L^2 T^{-1}");
  CHECK(text("\\boldsymbol{\\omega}") == "T^{-1}");
}

TEST_CASE("rounding errors are bounded where that is asked for, and hold", "[scene]") {
  const std::string ask = "spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}']\n";
  CHECK(Played(ask, sample()).quantity("T_{rot}").error.empty());
  const Played played(ask + "errors = true\n", turned_cross(3, 2, 1));
  const SceneQuantity& energy = played.quantity("T_{rot}");
  REQUIRE(energy.error.size() == 1);
  CHECK(energy.error[0] > 0);
  CHECK(energy.error[0] < 1e-12 * energy.value[0]);
}

TEST_CASE("an energy without a spin is refused, the tensor beside it is not", "[scene]") {
  const Played played("[ask]\nquantities = ['T_{rot}', 'I_{ij}']\n", sample());
  CHECK(
      played.messages() ==
      "bad-scene: `T_{rot}` is not evaluated: `\\boldsymbol{\\omega}` is needed, but the scene has no spin\n"
      "help: add `spin = [\"1 rad/s\", 0, 0]`, say\n");
  CHECK(played.value("I_{ij}", 8) == 26);
}

TEST_CASE("a letter without a value is named, with where to give it one", "[scene]") {
  const Played played("[ask]\nquantities = ['T_{trans}']\n", sample());
  CHECK(played.messages() ==
        "bad-scene: `T_{trans}` is not evaluated: `\\mathbf{V}` is needed, but has no value\n"
        "help: give it one under [values], or say under [symbols] that `\\mathbf{V}` is the mass, the "
        "position, the "
        "spin or a principal moment\n");
  const Played given("[values]\n'\\mathbf{V}' = [\"3 m/s\", 0, 0]\n[ask]\nquantities = ['T_{trans}']\n",
                     sample());
  CHECK(given.messages() == "");
  CHECK(given.value("T_{trans}") == 27);
  CHECK(given.quantity("T_{trans}").dimension->text() == "M L^2 T^{-2}");
}

TEST_CASE("a value's unit that contradicts the notes is reported", "[scene]") {
  const Played played(
      "spin = [1, 2, 3]\n[values]\n'\\mathbf{V}' = [\"3 kg\", 0, 0]\n[ask]\nquantities = ['T_{rot} + "
      "T_{trans}']\n",
      sample());
  CHECK(played.messages() ==
        "wrong-unit: in `T_{rot} + T_{trans}` terms of kg m^2/s^2 and of kg^3 are added\n");
}

TEST_CASE("an unknown quantity comes with a suggestion", "[scene]") {
  const Played played("spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rott}']\n", sample());
  CHECK(played.messages().find("T_{rott}") != std::string::npos);
  CHECK(played.messages().find("did you mean") != std::string::npos);
  CHECK(played.result.quantities.empty());
}

TEST_CASE("a vector with a value is turned, or needs the axes to be said", "[scene]") {
  const std::string ask =
      "[values]\n'\\mathbf{V}' = [1, 2, 3]\n[ask]\nquantities = ['I_2 V_1']\n" + std::string();
  const std::string at = racket;
  CHECK(Played(at + ask, turned_cross(3, 2, 1)).messages().find("axes = \"body\"") != std::string::npos);
  const Played body("axes = \"body\"\n" + at + ask, turned_cross(3, 2, 1));
  CHECK(body.messages() == "");
  CHECK(body.value("I_2 V_1") == Approx(20 * (std::sqrt(0.75) + 1)).epsilon(1e-13));
  const Played principal("axes = \"principal\"\n" + at + ask, turned_cross(3, 2, 1));
  CHECK(principal.messages() == "");
  CHECK(principal.value("I_2 V_1") == Approx(20).epsilon(1e-13));
}

TEST_CASE("a tensor whose components stand alone is that along the principal axes", "[scene]") {
  build::Page page;
  const build::Named tensor = page.tensor("J");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  WrittenForms forms;
  const build::Term letter = tensor;
  forms.asked.push_back({"J_{ij}", build::at(tensor, i, j).id, {i, j}, {}});
  forms.asked.push_back({"J", letter.id, {}, {}});
  forms.tree = page.tree;
  SceneFile scene;
  scene.axes = SceneAxes::principal;
  scene.symbols.tensor = {"J", {}, true};
  scene.symbols.principal_moments = {{"I_1", {}, false}, {"I_2", {}, false}, {"I_3", {}, false}};
  scene.asked.push_back({SceneAskKind::quantity, {"J_{ij}", {}}, "J_{ij}"});
  const Body body = turned_cross(3, 2, 1);
  const SceneResult result = evaluate_scene(scene, body, forms);
  CHECK(result.diagnostics.empty());
  CHECK(result.along_principal_axes);
  REQUIRE(result.quantities.size() == 1);
  REQUIRE(result.quantities[0].value.size() == 9);
  CHECK(result.quantities[0].value[0] == Approx(10).epsilon(1e-13));
  CHECK(result.quantities[0].value[1] == 0);
}

TEST_CASE("a large cloud is in memory once, whatever is asked of it", "[scene]") {
  if (!memory_is_our_own) return;
  const Body large = *random_cloud("cloud", 1'000'000, 3);
  const Body small = *random_cloud("cloud", 1'000, 3);
  constexpr double size = 32e6 / (1 << 20);  // MiB, of the copy that the scene takes
  const std::string energy = "spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}']\n";
  const std::string turned = "axes = \"body\"\nspin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}', 'I_1']\n";
  const std::string errors = "errors = true\n";
  for (const std::string& lines : {energy, energy + errors, turned, turned + errors}) {
    INFO(lines);
    const auto peak = [&](const Body& body) {
      return peak_memory_of([&] { return Played(lines, body).value("T_{rot}") > 0; });
    };
    CHECK(peak(large) - peak(small) < 1.15 * size);
  }
}

TEST_CASE("every scene in derivations/ gives all it is asked for", "[scene]") {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator("derivations/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path().string());
    const Played played(entry.path().string());
    CHECK(played.messages() == "");
    CHECK(!played.result.quantities.empty());
    for (const SceneQuantity& quantity : played.result.quantities) CHECK(quantity.dimension);
    ++scenes;
  }
  CHECK(scenes >= 4);
}

TEST_CASE("a body without particles is refused, and what is not finite is said to be so", "[scene]") {
  const std::string ask = "spin = [1, 2, 3]\n[ask]\nquantities = ['T_{rot}']\n";
  CHECK(Played(ask, Body{}).messages() == "bad-body: the body has no particles\n");
  const Body nan{"nan", {std::nan("")}, {{{0}, {0}, {0}}}, {}};
  CHECK(Played(ask, nan).messages() == "bad-scene: `T_{rot}` is not finite\n");
}

}  // namespace
}  // namespace rigor
