// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor scene FILE.toml`: the quantities that a scene asks of its body.
#pragma once

#include <ostream>
#include <string>

#include "app/grammar/command_line.h"
#include "check/form/forms.h"
#include "numeric/body/body.h"
#include "scene/file/scene_file.h"

namespace rigor {

/// A scene with all that it names.
struct LoadedScene {
  SceneFile scene;
  Body body;
  FormsReading reading;
};

/// Reads the scene, its body and what it needs of its notes. What is wrong goes to `err`, and the code says
/// what kind it is.
[[nodiscard]] ExitCode load_scene(const std::string& path, SourceMap& sources, LoadedScene& loaded,
                                  std::ostream& err);

/// Pictures are written next to the scene's file.
[[nodiscard]] ExitCode compute_scenes(const SceneCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
