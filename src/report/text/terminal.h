// SPDX-License-Identifier: GPL-3.0-or-later
// A report as text for people: per file one line a step, then every diagnostic with its source line and, for
// a refutation, its sample; at the end why steps are open, most first, and one line with all counts.
//
//   notes/vectors.tex
//      12  (3)  \mathbf{A}\times\mathbf{B} = \mathbf{B}\times\mathbf{A}  refuted
//
//   notes/vectors.tex:12:28: refuted: the sides differ: left is 1, right is -1 [refuted]
//      12 | \mathbf{A}\times\mathbf{B} = \mathbf{B}\times\mathbf{A} \tag{3}
//         | ~~~~~~~~~~~~~~~~~~~~~~~~~~ ^ ~~~~~~~~~~~~~~~~~~~~~~~~~~
//   sample: \mathbf{A} = (1, 0, 0), \mathbf{B} = (0, 1, 0); component 3: left 1, right -1
//
//   1 step: 0 proved, 0 definitions, 0 given, 1 refuted; 0 undecided, 0 not understood, 0 skipped; 0.4 ms
#pragma once

#include <cstdint>
#include <string>

#include "check/step/failure_rule.h"
#include "source/source_map.h"

namespace rigor {

struct TerminalOptions {
  bool color = false;
  std::uint32_t width = 110;             // in cells; a step is never cut to less than 20
  bool dimensions = false;               // with a table of what was found of each symbol's dimension
  bool all_causes = false;               // each cause why something is open, rather than a screen of them
  const KnownFindings* known = nullptr;  // nothing more is said of these
};

/// The same bytes for the same report, but for the time in the last line.
[[nodiscard]] std::string print_report(const Report& report, const SourceMap& sources,
                                       const TerminalOptions& options = {});

/// The part of it about what is wrong in one file: each diagnostic, with sample and repairs. Empty if there
/// is nothing to say; else it begins with an empty line.
[[nodiscard]] std::string print_diagnostics(const FileReport& file, const SourceMap& sources,
                                            const TerminalOptions& options = {});

/// The last line, without its line break. How many refutations were expected, and how many errors and
/// warnings there are, is said only where there are any.
[[nodiscard]] std::string print_summary(const Report& report);

}  // namespace rigor
