// SPDX-License-Identifier: GPL-3.0-or-later
// Directives that may settle open rows, as far as the help of their diagnostics names them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/step/report.h"

namespace rigor {

/// A line of a sidecar, and below which line it stands: `at start`, `at section "Energy"`.
struct PlacedLine {
  std::string anchor;
  std::string directive;  // `constant m`
  friend bool operator==(const PlacedLine&, const PlacedLine&) = default;
};

/// Any one of these may settle the same rows; each may be several lines.
struct Candidate {
  std::vector<std::vector<PlacedLine>> alternatives = {};
  std::size_t rows = 0;               // that are open for this cause
  std::vector<std::string> why = {};  // the causes in words
};

/// One for each cause that names a directive, those that alone keep most rows open first; then one for each
/// set of causes that rows have in common. A directive holds from the headings of its rows, if these are few,
/// or else from the start of the notes. What only silences or asks (`claim`, `law next`) settles nothing and
/// is left out.
[[nodiscard]] std::vector<Candidate> candidates_of(const FileReport& file);

/// The lines as they stand in a sidecar, each place once; ends with a line break.
[[nodiscard]] std::string sidecar_lines(const std::vector<PlacedLine>& lines);

}  // namespace rigor
