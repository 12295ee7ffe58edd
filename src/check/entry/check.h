// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to verdicts.
#pragma once

#include <string>

#include "check/place/check_options.h"
#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// Never throws for anything that is in the notes. A file that cannot be read is reported as such.
[[nodiscard]] FileReport check_file(SourceMap& sources, const std::string& path,
                                    const CheckOptions& options = {});

/// The same for text in memory (`path` decides the format and is what diagnostics show).
[[nodiscard]] FileReport check_text(SourceMap& sources, const std::string& path, std::string text,
                                    const CheckOptions& options = {});

}  // namespace rigor
