// SPDX-License-Identifier: GPL-3.0-or-later
// Sample bodies that the command line or a scene names.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/grammar/exit_code.h"
#include "numeric/body/body.h"
#include "source/source_map.h"

namespace rigor {

/// Where bodies are looked for by name: `bodies` next to the file and in the folder above it; in the working
/// directory `bodies` and `derivations/bodies`.
[[nodiscard]] std::vector<std::string> body_folders(const std::string& beside);

/// Names, files, or folders, all of whose bodies are meant. What is wrong goes to `err`.
[[nodiscard]] ExitCode read_bodies(const std::vector<std::string>& names, const std::string& beside,
                                   SourceMap& sources, std::vector<Body>& bodies, std::ostream& err);

}  // namespace rigor
