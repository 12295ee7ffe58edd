// SPDX-License-Identifier: GPL-3.0-or-later
// Factors side by side that can be something else than a product.
#pragma once

#include <cstdint>
#include <optional>

#include "elaborate/name/spelled.h"
#include "elaborate/reading/reading.h"

namespace rigor {

/// The factors without brackets that only show what the letter before them depends on: `m\,\ddot x(t)` is
/// `m\ddot x`.
[[nodiscard]] std::vector<SyntaxChild> without_arguments(const Reading& reading,
                                                         std::span<const SyntaxChild> factors);

/// What a bracket directly behind a symbol is: a factor, the argument of a function, or either of them.
enum class BracketPart : std::uint8_t {
  factor,
  argument,
  open,
};
/// An argument where the section writes the symbol as a function, or behind any letter where it is 0. That it
/// is open is noted in what the reading found.
[[nodiscard]] BracketPart part_of_bracket(Reading& reading, SyntaxId function, SyntaxId bracket);

/// A symbol that is named after the function and its argument: nothing else is known of it.
[[nodiscard]] MaybeTyped value_of_function(Reading& reading, SyntaxId function, SyntaxId bracket,
                                           const Around& around);

/// n of `f(x)^n` where `(x)` is the argument of f: a power of the value, and no factor x^n.
[[nodiscard]] std::optional<int> power_of_value(Reading& reading, SyntaxId function, const SyntaxChild& next);
[[nodiscard]] MaybeTyped power_of_value(Reading& reading, SyntaxId function, SyntaxId power, int exponent,
                                        const Around& around);

/// The first such place among the factors of a term, if any.
[[nodiscard]] std::optional<SpelledPart> doubt_of_product(Reading& reading,
                                                          std::span<const SyntaxChild> factors);

}  // namespace rigor
