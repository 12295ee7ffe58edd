// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's results as one JSON object.
#pragma once

#include <string>

#include "scene/quantity/scene.h"
#include "source/source_map.h"

namespace rigor {

/// Ends with a line break; keys are in a fixed order; numbers as they are, what is not finite as `null`.
/// `times`: with the milliseconds of what was computed, which differ from run to run.
[[nodiscard]] std::string to_json(const SceneResult& result, const SourceMap& sources, bool times = false);

}  // namespace rigor
