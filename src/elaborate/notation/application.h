// SPDX-License-Identifier: GPL-3.0-or-later
// Factors side by side that can be something else than a product.
#pragma once

#include "elaborate/name/spelled.h"
#include "elaborate/reading/reading.h"

namespace rigor {

/// The factors without brackets that only show what the letter before them depends on: `m\,\ddot x(t)` is
/// `m\ddot x`.
[[nodiscard]] std::vector<SyntaxChild> without_arguments(const Reading& reading,
                                                         std::span<const SyntaxChild> factors);

/// The first such place among the factors of a term, if any.
[[nodiscard]] std::optional<SpelledPart> doubt_of_product(const Reading& reading,
                                                          std::span<const SyntaxChild> factors);

}  // namespace rigor
