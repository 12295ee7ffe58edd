// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/stability.h"

#include <cmath>
#include <numbers>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "numeric/body/body.h"
#include "scene/scene_functions.h"

namespace rigor {
namespace {

const std::vector<double> pushes{0.1, 0.03, 0.01, 0.003, 0.001};

/// The notes in derivations/, their three stability frequencies and Euler's equations without a torque.
struct FromNotes {
  SourceMap sources;
  Diagnostics diagnostics;
  SceneFile scene;
  WrittenForms forms;

  FromNotes(const std::string& at, const std::string& equations, const std::string& quantities) {
    const FileId file =
        sources.add("derivations/scenes/test.toml",
                    "notes = \"../rigid-bodies.md\"\nbody = \"any\"\nspin = [1, 1, 1]\nat = \"" + at +
                        "\"\n[values]\n'\\boldsymbol{\\tau}' = [0, 0, 0]\n[motion]\nequations = \"" +
                        equations + "\"\nduration = 1\n[ask]\nquantities = [" + quantities + "]\n");
    const auto read = read_scene(sources, file, diagnostics);
    REQUIRE(read);
    scene = *read;
    FormRequest request{.asked = asked_of_notes(scene)};
    request.at = scene.at;
    request.only = std::vector{equations};
    FormsReading reading = read_forms(sources, scene.notes_path(), request);
    forms = std::move(reading.forms);
  }
};

FromNotes racket() {
  return {"A thrown racket", "(22)", "'(\\Omega_1)^2', '(\\Omega_2)^2', '(\\Omega_3)^2'"};
}

Body cross_of_masses(double a, double b, double c) {
  return *point_masses("cross", {1, 1, 1, 1, 1, 1},
                       {{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}});
}

TEST_CASE("the notes' stability frequencies are those of the notes' motion, up to the push squared",
          "[stability]") {
  const FromNotes notes = racket();
  // All orders of the moments, so that each axis is once the one between.
  const std::vector<Body> bodies{cross_of_masses(3, 2, 1), cross_of_masses(1, 3, 2),
                                 cross_of_masses(2, 1, 3)};
  const auto all = measure_stability(notes.scene, bodies, notes.forms, 5, pushes);
  REQUIRE(all.size() == 3);
  int growing = 0;
  for (const BodyStability& body : all) {
    CHECK(body.diagnostics.empty());
    REQUIRE(body.axes.size() == 3);
    for (const StabilityMeasurement& axis : body.axes) {
      CHECK(axis.problem == "");
      CHECK(std::abs(axis.order - 2) < 0.05);
      CHECK(axis.points.back().error < 1e-5);
      growing += axis.fate == SpinFate::grows ? 1 : 0;
    }
  }
  CHECK(growing == 3);
}

TEST_CASE("a wrong formula is found out: its error does not fall with the push", "[stability]") {
  const FromNotes notes = racket();
  const Body body = cross_of_masses(3, 2, 1);
  const SceneFunctions functions = scene_functions(notes.scene, body, notes.forms);
  REQUIRE(functions.rates);
  const SpinFunction wrong = [&](const Vector3& spin) { return 1.01 * functions.asked[0](spin); };
  const StabilityMeasurement measured = measure_stability(functions.rates, wrong, 0, 5, pushes);
  CHECK(measured.points.back().error > 0.009);
  CHECK(std::abs(measured.order) < 1);
}

TEST_CASE("where two moments agree nothing oscillates or grows, up to the push squared", "[stability]") {
  const FromNotes notes = racket();
  const Body body = cross_of_masses(2, 2, 1);  // I₁ = I₂
  const auto all = measure_stability(notes.scene, {&body, 1}, notes.forms, 5, pushes);
  REQUIRE(all[0].axes.size() == 3);
  for (const std::size_t axis : {0, 1}) {
    CHECK(all[0].axes[axis].fate == SpinFate::neither);
    CHECK(all[0].axes[axis].predicted == 0);
    CHECK(all[0].axes[axis].points.back().error < 1e-5);
    CHECK(std::abs(all[0].axes[axis].order - 2) < 0.1);
  }
  CHECK(all[0].axes[2].fate == SpinFate::oscillates);
  CHECK(all[0].axes[2].points.back().error < 1e-9);  // exact for a symmetric top, whatever the push
}

TEST_CASE("a body whose motion the equations do not determine is said to be one", "[stability]") {
  const FromNotes notes = racket();
  const Body rod = *point_masses("rod", {1, 1}, {{0, 0, 1}, {0, 0, -1}});
  const auto all = measure_stability(notes.scene, {&rod, 1}, notes.forms, 5, pushes);
  REQUIRE(all.size() == 1);
  CHECK(all[0].axes.empty());
  REQUIRE(!all[0].diagnostics.empty());
  CHECK(all[0].diagnostics[0].message.find("component 3") != std::string::npos);
}

TEST_CASE("a spin that stays where it is, or is lost on the way, gives no event", "[stability]") {
  const SpinFunction oscillates = [](const Vector3&) { return 1.0; };
  const SpinFunction grows = [](const Vector3&) { return -1.0; };
  const auto problem = [](const SpinRates& rates, const SpinFunction& squared) {
    const StabilityMeasurement measured = measure_stability(rates, squared, 0, 1, pushes);
    for (const StabilityPoint& point : measured.points) CHECK(std::isnan(point.measured));
    return measured.problem;
  };
  const std::string missing = "not every push gave what the formula says";
  const SpinRates none = [](const Vector3&) { return Vector3{}; };
  CHECK(problem(none, oscillates) == missing);  // the third component is 0 in every row
  CHECK(problem(none, grows) == missing);
  // Not a number once the push has grown by a tenth.
  const SpinRates lost = [](const Vector3& spin) {
    return Vector3{0, spin[1] < 0.11 ? 0.01 : std::nan(""), 0};
  };
  const std::vector<double> one{0.1};
  CHECK(measure_stability(lost, grows, 0, 1, one).problem == missing);
}

TEST_CASE("a scalar of the rates of the spin is no function where there is no law", "[stability]") {
  const FromNotes notes{"A thrown racket", "(999)", "'\\dot{\\omega}_1'"};
  const Body body = cross_of_masses(3, 2, 1);
  const SceneFunctions functions = scene_functions(notes.scene, body, notes.forms);
  CHECK(!functions.rates);
  REQUIRE(functions.asked.size() == 1);
  CHECK(!functions.asked[0]);
  CHECK(functions.diagnostics.back().message.find("the rates of the spin are not known") !=
        std::string::npos);
}

TEST_CASE("the notes' precession of a symmetric top is that of the notes' motion", "[stability]") {
  const FromNotes notes{"The symmetric top", "(22)", "'\\Omega'"};
  for (const Body& body : {cross_of_masses(2, 2, 1), cross_of_masses(1, 1, 3)}) {
    const SceneFunctions functions = scene_functions(notes.scene, body, notes.forms);
    REQUIRE(functions.rates);
    REQUIRE(functions.asked.size() == 1);
    REQUIRE(functions.asked[0]);
    for (const double push : {0.001, 0.1, 1.0}) {
      const Vector3 start{5 * push, 0, 5};
      const double predicted = functions.asked[0](start);
      const double quarter = std::numbers::pi / 2 / std::abs(predicted);
      const Motion motion =
          integrate(functions.rates, {.spin = start, .duration = quarter, .rows = 2, .tolerance = 1e-14});
      REQUIRE(motion.stopped.empty());
      const Vector3& end = motion.spins.back();  // the part across axis 3 was along axis 1
      CHECK(std::atan2(end[1], end[0]) / quarter == Approx(predicted).epsilon(1e-10));
    }
  }
}

}  // namespace
}  // namespace rigor
