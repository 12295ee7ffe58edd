// SPDX-License-Identifier: GPL-3.0-or-later
// A TOML file as a tree of values, each with its place. Entries of a table are in the order of the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

enum class TomlKind : std::uint8_t { string, number, boolean, date, array, table };

/// `a string`, `a number`…
[[nodiscard]] std::string_view name_of(TomlKind kind);

struct TomlEntry;

struct TomlValue {
  TomlKind kind = TomlKind::table;
  Span span = {};
  std::string text;                // of a string
  double number = 0;               // may be NaN or infinite: TOML has both
  bool whole = false;              // of a number: written as an integer
  bool truth = false;              // of a boolean
  std::vector<TomlValue> items;    // of an array
  std::vector<TomlEntry> entries;  // of a table
};

struct TomlEntry {
  std::string key;
  Span key_span = {};
  TomlValue value;
};

/// The top table of a file that is in the source map. Nothing where it is no TOML, is nested too deep or too
/// large: the diagnostic says where. A key that is given twice is such a mistake. Limits: 16 MiB, 64 tables
/// in one another.
[[nodiscard]] std::optional<TomlValue> parse_toml(const SourceMap& sources, FileId file,
                                                  Diagnostics& diagnostics);

}  // namespace rigor
