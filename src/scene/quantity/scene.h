// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's quantities, evaluated on its body. What is computed follows from what the compiled expressions
// read: principal moments only where a letter bound to them is read, axes only where the spin or places must
// be turned to them, the motion only where something is asked over the time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expr/statement/written_forms.h"
#include "numeric/body/body.h"
#include "scene/file/scene_file.h"
#include "scene/motion/motion.h"
#include "scene/quantity/explain.h"

namespace rigor {

struct SceneQuantity {
  std::string source;              // as asked
  int axes = 0;                    // 3^axes components, row by row
  std::vector<double> value = {};  // at the time 0
  std::vector<double> error = {};  // at most so wrong, each; empty: not known
  std::optional<Dimension> dimension = {};
  std::vector<std::vector<double>> rows = {};  // over the time, if asked: of each row of the motion
};

/// Do the errors of a scalar leave open on which side of 0 it is? Of a square frequency, say, whether a spin
/// is stable. False where no errors are known.
[[nodiscard]] bool has_open_sign(const SceneQuantity& quantity);

/// How constant a quantity stayed while the body moved.
struct SceneDrift {
  std::string source;
  double relative = 0;    // greatest change of any component, over the greatest size; not a number: a row is
                          // not finite
  bool constant = false;  // no more than the integration explains: 1e4 times its tolerance, at most 1e-4
  bool in_space = false;  // of the components along fixed axes
};

struct SceneCounts {
  std::size_t computed = 0;
  std::size_t skipped = 0;
};

struct SceneResult {
  std::string title;
  std::string body;
  bool along_principal_axes = false;  // components are along the body's principal axes
  std::vector<SceneQuantity> quantities;
  std::optional<Motion> motion;
  std::optional<Vector3> moments;  // along the axes of the components, if they were needed
  std::vector<SceneDrift> drifts;
  std::vector<SceneNode> nodes;
  Diagnostics diagnostics;

  [[nodiscard]] SceneCounts counts() const;
};

/// `forms` must answer `asked_of_notes(scene)`; where a motion is asked, its chains must have the tag or
/// heading `scene.motion->equations`. What cannot be computed is a diagnostic at its place in the scene's
/// file; the other quantities are there. A body that is moved in is in memory once, whatever is asked.
[[nodiscard]] SceneResult evaluate_scene(const SceneFile& scene, Body body, const WrittenForms& forms);

}  // namespace rigor
