// SPDX-License-Identifier: GPL-3.0-or-later
// The diagnostic of an equation that reads as a law: nothing is known about some of its symbols, and known
// ones with similar names may be meant.
#pragma once

#include <string>
#include <vector>

#include "check/verdict/judge.h"

namespace rigor {

/// `a`, `b` and `c`: each name once, in back-ticks.
[[nodiscard]] std::string quoted_names(const ExprTree& tree, const std::vector<SymbolId>& symbols);

/// What the notes name: each symbol, or what it is a derivative of; of equal names the first.
[[nodiscard]] std::vector<SymbolId> bases_of(const ExprTree& tree, const std::vector<SymbolId>& symbols);

/// A symbol's name without face and braces: `\boldsymbol{\omega}` is `\omega`.
[[nodiscard]] std::string bare_name(std::string name);

/// The claim depends on these symbols, and nothing says that all their values are meant. `assumed`: it fails
/// though assumptions bear on it.
[[nodiscard]] Diagnostic law_diagnostic(const ExprTree& tree, const Names& names, const Claim& claim,
                                        const std::vector<SymbolId>& open, bool assumed);

}  // namespace rigor
