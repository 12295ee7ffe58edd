// SPDX-License-Identifier: GPL-3.0-or-later
// How verdicts name letters, and what is said of a conclusion that follows from nothing.
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

/// The claim is a law by its letters, but announced as a conclusion, or assumptions bear on it: and it
/// follows from nothing. Known letters with similar names may be meant.
[[nodiscard]] Diagnostic without_ground(const ExprTree& tree, const Names& names, const Claim& claim,
                                        const Judgement& judgement);

}  // namespace rigor
