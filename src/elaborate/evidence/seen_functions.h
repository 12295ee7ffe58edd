// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that are written with their argument: functions before other brackets as well.
#pragma once

#include <string_view>
#include <vector>

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// `\omega(k) = ck`: the first side of a chain.
void see_functions(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// "where $n(E)$ is the density of states", "with $f(x) = x^2$".
void see_inline_functions(std::string_view text, Evidence& evidence);

/// Can the symbol, which `functions` has with its arguments, be applied to this bracket? Not to one that it
/// is in itself, `n(n + 1)`, and a vector only to its own arguments.
[[nodiscard]] const std::set<std::string>* arguments_of(const SyntaxTree& syntax, SyntaxId symbol,
                                                        SyntaxId bracket, const Evidence& evidence);

}  // namespace rigor
