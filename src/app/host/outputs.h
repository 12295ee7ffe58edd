// SPDX-License-Identifier: GPL-3.0-or-later
// Files that a command writes: they never take the place of what it reads.
#pragma once

#include <optional>
#include <string>

#include "source/source_map.h"

namespace rigor {

/// The same place on the disk, by whatever names; also where nothing is there yet.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// Which of the files that were read would be overwritten by writing to a path.
[[nodiscard]] std::optional<std::string> overwritten_by(const std::string& path, const SourceMap& sources);

}  // namespace rigor
