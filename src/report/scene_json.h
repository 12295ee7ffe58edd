// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's results as one JSON object.
#pragma once

#include <string>

#include "scene/scene.h"
#include "source/source_map.h"

namespace rigor {

/// Ends with a line break; keys stand in a fixed order; numbers as they are, what is not finite as `null`.
/// Only `milliseconds` differs between two runs.
[[nodiscard]] std::string to_json(const SceneResult& result, const SourceMap& sources);

}  // namespace rigor
