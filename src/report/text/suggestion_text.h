// SPDX-License-Identifier: GPL-3.0-or-later
// Directives that would settle open rows, for people:
//
//   settles  a line of yours
//         2  at section "Vectors": rigor: vector \mathbf{r}
//            since `\mathbf{r}` can be complex, but it is proved for real vectors only
//            notes.md:17:44 (3)  not understood -> proved  r_j r_j = |\mathbf r|^2
#pragma once

#include <string>

#include "report/suggest/suggest.h"
#include "report/text/terminal.h"

namespace rigor {

/// First what is accepted, then what is held back, each with all rows that it changes for the worse and the
/// first ones that it settles; then a line that counts.
[[nodiscard]] std::string suggestion_text(const Suggestions& suggestions, const TerminalOptions& options);

}  // namespace rigor
