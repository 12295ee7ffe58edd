// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's law of motion and the scalars it asks for as functions of the spin: for measurements that make
// motions of their own.
#pragma once

#include <span>
#include <vector>

#include "scene/quantity/scene.h"
#include "scene/stability.h"

namespace rigor {

struct SceneFunctions {
  SpinRates rates;  // empty: the scene has no law of motion for this body
  std::vector<SpinFunction>
      asked;  // in the order of the scene; empty ones could not be compiled or have no value
  Diagnostics diagnostics;
};

/// As `evaluate_scene`, without evaluating anything. All three must outlive the functions.
[[nodiscard]] SceneFunctions scene_functions(const SceneFile& scene, const Body& body,
                                             const WrittenForms& forms);

/// One body's part of a table: the scene asks for Ω² of the three axes, in this order.
struct BodyStability {
  std::string body;
  std::vector<StabilityMeasurement> axes;
  Diagnostics diagnostics;
};

/// `spin`: in rad/s.
[[nodiscard]] std::vector<BodyStability> measure_stability(const SceneFile& scene,
                                                           std::span<const Body> bodies,
                                                           const WrittenForms& forms, double spin,
                                                           std::span<const double> pushes);

}  // namespace rigor
