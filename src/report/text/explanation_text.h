// SPDX-License-Identifier: GPL-3.0-or-later
// Explained chains as text for a terminal, as LaTeX for amsmath, and as MathML.
#pragma once

#include <string>
#include <vector>

#include "report/text/terminal.h"
#include "report/wording/explained.h"

namespace rigor {

/// On lines of Unicode, each with its rule at the right.
[[nodiscard]] std::string explanation_text(const std::vector<ExplainedChain>& chains,
                                           const TerminalOptions& options);
/// An `align*` for each chain; lines that are too long for a page are cut before + and −.
[[nodiscard]] std::string explanation_latex(const std::vector<ExplainedChain>& chains);
/// A `<math display="block">` on one line for each chain.
[[nodiscard]] std::string explanation_mathml(const std::vector<ExplainedChain>& chains);

}  // namespace rigor
