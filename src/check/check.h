// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to verdicts.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "check/report.h"
#include "source/source_map.h"

namespace rigor {

/// Of which refuted steps nearest true statements are looked for.
enum class Repairs : std::uint8_t { none, of_unexpected, of_all };

struct CheckOptions {
  std::optional<std::string> sidecar =
      {};  // a path; without it, `NAME.rigor` beside the notes, if there is one
  std::function<void(std::size_t done, std::size_t all)> progress =
      {};  // called after each display; may be empty
  Repairs repairs = Repairs::of_unexpected;
};

/// Never throws for anything that is in the notes. A file that cannot be read is reported as such.
[[nodiscard]] FileReport check_file(SourceMap& sources, const std::string& path,
                                    const CheckOptions& options = {});

/// The same for text in memory (`path` decides the format and is what diagnostics show).
[[nodiscard]] FileReport check_text(SourceMap& sources, const std::string& path, std::string text,
                                    const CheckOptions& options = {});

}  // namespace rigor
