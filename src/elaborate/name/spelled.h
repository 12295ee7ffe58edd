// SPDX-License-Identifier: GPL-3.0-or-later
// Letters in a product that can be one word or one name, or act on the bracket after them: `Tr(AB)`, `rot
// A`, `KE`, the segment `AB`, `E[X^2]`, `\mathcal L(fg)`.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elaborate/name/names.h"
#include "latex/token/syntax.h"

namespace rigor {

struct SpelledPart {
  Span span;
  std::string message;
  std::vector<std::string> help;
};

/// The first such place among the factors of a term, if any. Letters that a directive declares are factors.
[[nodiscard]] std::optional<SpelledPart> spelled_part(const SyntaxTree& syntax,
                                                      std::span<const SyntaxChild> factors,
                                                      const Names& names);

}  // namespace rigor
