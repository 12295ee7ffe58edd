// SPDX-License-Identifier: GPL-3.0-or-later
// Upper indices: where `x^\mu` or `x^1` stands, `x^2` need not be a square.
#pragma once

#include <string_view>
#include <vector>

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// `x^1`, `x^0`, `x^\mu`, `g^{ij}`, and `a^kb_k` in the sides of one chain.
void see_raised(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// "The coordinates $x^i$", "upper indices", "superscripts label …".
void see_said_raised(std::string_view text, Evidence& evidence);

/// Can the number above the symbol be an index?
[[nodiscard]] bool may_be_raised(const WrittenSymbol& symbol, const Evidence& evidence);

}  // namespace rigor
