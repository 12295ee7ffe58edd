// SPDX-License-Identifier: GPL-3.0-or-later
// A diagnostic as text, with its source line and a caret:
//
//   notes/euler.tex:57:41: error: index `j` occurs 3 times in one term [index-repeats]
//      57 |   \epsilon_{ijk} I_{jl} \omega_l \omega_j
//         |              ~      ~                   ^
//   help: with `I_{kl}` for `I_{jl}` the free index matches the left side
#pragma once

#include <string>

#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

struct RenderOptions {
  bool color = false;
  std::uint32_t width = 160;  // longer source lines are cut around the caret, with `…`
};

/// Ends with a line break. The rest of the diagnostic's own span and the labels on the caret's line are
/// underlined with `~`; a label elsewhere, or with a text, gets a `note:` line. Tabs are printed as blanks,
/// what could steer a terminal as `?`. Cost: O(width) for each place, whatever the length of its line.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, const SourceMap& sources,
                                 const RenderOptions& options = {});

}  // namespace rigor
