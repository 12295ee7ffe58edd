// SPDX-License-Identifier: GPL-3.0-or-later
// What was found in one file, with the texts that its places point into, as bytes: from a process that
// checked it to the one that prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// All texts of the map are packed with it.
[[nodiscard]] std::string pack(const FileReport& file, const SourceMap& sources);

/// Its texts are added to the map after those that are there. Empty, and nothing is added, if these are not
/// the bytes of a report.
[[nodiscard]] std::optional<FileReport> unpack(std::string_view bytes, SourceMap& sources);

}  // namespace rigor
