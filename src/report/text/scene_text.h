// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's results for people.
#pragma once

#include <string>

#include "scene/quantity/scene.h"

namespace rigor {

struct SceneTextOptions {
  bool explain = false;  // what was computed, what was not and why, with times
};

/// One line a quantity, tensors row by row; then what stayed constant; then, if asked for, what was computed.
/// Diagnostics are not among it. Without `explain` the same result gives the same bytes.
[[nodiscard]] std::string print_scene(const SceneResult& result, const SceneTextOptions& options = {});

}  // namespace rigor
