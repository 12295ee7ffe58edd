// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence that letters are matrices or operators, whose products keep their order: a displayed matrix, a
// commutator, a dagger, a transpose, a trace, a ket, hats where operators are about, and words.
#pragma once

#include <string_view>
#include <vector>

#include "elaborate/evidence/evidence.h"
#include "latex/split/split.h"

namespace rigor {

/// What one chain shows; `sides` are its sides as they were parsed.
void see_order(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
               Evidence& evidence);

/// "The operators $x$ and $p$": the words of a section, with what is set in the line. Capitals of a section
/// that speaks of matrices or operators are counted in, and so is what its sentence displays.
void see_words(std::string_view text, Evidence& evidence);

/// "Heisenberg picture", "Quaternions": in such a section any letter may be one.
void see_heading(std::string_view title, Evidence& evidence);

/// When all is seen: hatted letters are operators where operators are about, else unit vectors.
void settle_order(Evidence& evidence);

}  // namespace rigor
