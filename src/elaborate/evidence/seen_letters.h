// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence that letters are real, complex, functionals or the ends of a segment: an order, a conjugate,
// square brackets, and words.
#pragma once

#include <string_view>
#include <vector>

#include "elaborate/evidence/evidence.h"
#include "latex/split/split.h"

namespace rigor {

/// What one chain shows; `sides` are its sides as they were parsed.
void see_letters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                 Evidence& evidence);

/// "where $a$, $b$ are real numbers", "for $x > 0$", "complex amplitudes", "in the triangle $ABC$".
void see_said(std::string_view text, Evidence& evidence);

}  // namespace rigor
