// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of an equation that reads as a law: which symbols nothing is known of, and which known ones
// may be meant.
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

/// The claim depends on these symbols, of which nothing says that all values are meant. `assumed`: it fails
/// though assumptions bear on it.
[[nodiscard]] Diagnostic law_diagnostic(const ExprTree& tree, const Names& names, const Claim& claim,
                                        const std::vector<SymbolId>& open, bool assumed);

}  // namespace rigor
