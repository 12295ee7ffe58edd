// SPDX-License-Identifier: GPL-3.0-or-later
// A settings file, `rigor.toml`: what `rigor check` is to do where the command line says nothing.
//
//   files = ["notes", "appendix.md"]               # files and folders
//   sidecars = { "appendix.md" = "shared.rigor" }  # else NAME.rigor beside the notes
//   strict = true                                  # or: fail-on = ["refuted", "suspect"]
//   jobs = 0
//   effort = 8000000
//
// Paths are those of the file's own folder.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

struct Settings {
  std::vector<std::string> files = {};
  std::map<std::string, std::string> sidecars = {};  // of notes, by a path as `place_on_disk` gives it
  std::optional<bool> strict = {};
  std::optional<std::set<Severity>> fail_on = {};
  std::optional<std::size_t> jobs = {};
  std::optional<std::uint64_t> effort = {};
};

inline constexpr const char* settings_name = "rigor.toml";

/// What is wrong with the file is in `diagnostics`; then the settings are not to be used.
[[nodiscard]] Settings read_settings(const std::string& path, SourceMap& sources, Diagnostics& diagnostics);

/// The same for all names of a file.
[[nodiscard]] std::string place_on_disk(const std::string& path);

}  // namespace rigor
