// SPDX-License-Identifier: GPL-3.0-or-later
// A scene on the notes in derivations/, read and evaluated for a test, and bodies for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "numeric/body/body.h"
#include "scene/file/body_file.h"
#include "scene/file/scene_file.h"
#include "scene/quantity/scene.h"
#include "source/read_file.h"

namespace rigor {

/// A scene on the notes in derivations/, from its lines.
struct Played {
  SourceMap sources;
  Diagnostics diagnostics;  // of the file, the notes and the evaluation
  SceneResult result;

  Played(const std::string& lines, const Body& body) {
    play(sources.add("derivations/scenes/test.toml",
                     "notes = \"../rigid-bodies.md\"\nbody = \"test\"\n" + lines),
         &body);
  }
  /// A scene of derivations/scenes, with its own body.
  explicit Played(const std::string& path) {
    const auto text = read_file(path);
    REQUIRE(text);
    play(sources.add(path, *text), nullptr);
  }

  void play(FileId file, const Body* body) {
    const auto scene = read_scene(sources, file, diagnostics);
    if (!scene) return;
    std::optional<Body> own;
    if (body == nullptr) {
      const auto path = find_body(scene->body.text, {"derivations/bodies"});
      REQUIRE(path);
      own = read_body_file(*path, sources, diagnostics);
      REQUIRE(own);
    }
    FormRequest request{.asked = asked_of_notes(*scene)};
    if (!scene->at.empty()) request.at = scene->at;
    request.only = scene->motion ? std::vector{scene->motion->equations.text} : std::vector<std::string>();
    const FormsReading reading = read_forms(sources, scene->notes_path(), request);
    diagnostics = reading.report.diagnostics;
    result = evaluate_scene(*scene, body == nullptr ? std::move(*own) : *body, reading.forms);
    diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
  }

  [[nodiscard]] const SceneQuantity& quantity(const std::string& source) const {
    static const SceneQuantity none;
    for (const SceneQuantity& each : result.quantities) {
      if (each.source == source) return each;
    }
    return none;
  }
  [[nodiscard]] double value(const std::string& source, std::size_t component = 0) const {
    const auto& values = quantity(source).value;
    return component < values.size() ? values[component] : std::nan("");
  }
  [[nodiscard]] bool computed(const std::string& node) const {
    return std::any_of(result.nodes.begin(), result.nodes.end(),
                       [&](const SceneNode& each) { return each.name == node && each.computed; });
  }
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const Diagnostic& each : diagnostics) {
      all += std::string(info(each.kind).name) + ": " + each.message + "\n";
      for (const std::string& help : each.help) all += "help: " + help + "\n";
    }
    return all;
  }
};

/// Two of each at ±a e₁, ±b e₂, ±c e₃, of 1 kg each: I₁ = 2(b² + c²) and so on.
inline Body cross_of_masses(double a, double b, double c) {
  return *point_masses("cross", {1, 1, 1, 1, 1, 1},
                       {{a, 0, 0}, {-a, 0, 0}, {0, b, 0}, {0, -b, 0}, {0, 0, c}, {0, 0, -c}});
}

/// The same, turned by 30° about the third axis.
inline Body turned_cross(double a, double b, double c) {
  const double s = 0.5;
  const double k = std::sqrt(0.75);
  return *point_masses("turned", {1, 1, 1, 1, 1, 1},
                       {{a * k, a * s, 0},
                        {-a * k, -a * s, 0},
                        {-b * s, b * k, 0},
                        {b * s, -b * k, 0},
                        {0, 0, c},
                        {0, 0, -c}});
}

// Moments 2·(4 + 1) = 10, 2·(9 + 1) = 20 and 2·(9 + 4) = 26.
inline Body sample() { return cross_of_masses(3, 2, 1); }

inline constexpr const char* racket = "at = \"A thrown racket\"\n";
inline constexpr const char* euler =
    "[motion]\nequations = \"(22)\"\nduration = \"20 s\"\n[values]\n'\\boldsymbol{\\tau}' = [0, 0, 0]\n";

}  // namespace rigor
