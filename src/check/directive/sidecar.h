// SPDX-License-Identifier: GPL-3.0-or-later
// A sidecar: directives for notes that must not be touched, below lines that say where in the notes they
// stand.
//
//   particles \alpha                # from the start of the notes
//   at (6)                          # an equation's number; also: at label eq:lagrange
//   claim A_iA_i = A^2
//   at section "Kinetic energy"     # directly below the heading
//   at line 57
//   at start                        # from the start of the notes again
#pragma once

#include <string>
#include <vector>

#include "base/span.h"
#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

enum class AnchorKind : std::uint8_t { start, tag, label, section, line };

struct Anchor {
  AnchorKind kind = AnchorKind::start;
  std::string text;        // `(6)`, the label, the title
  std::uint32_t line = 0;  // AnchorKind::line
  Span span;               // in the sidecar
};

struct SidecarLine {
  Anchor anchor;
  Span directive;
};

[[nodiscard]] std::vector<SidecarLine> read_sidecar(const SourceMap& sources, FileId file,
                                                    Diagnostics& diagnostics);

}  // namespace rigor
