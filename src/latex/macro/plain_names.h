// SPDX-License-Identifier: GPL-3.0-or-later
// Names that every LaTeX has for signs, and controls around a part that only set the spaces beside it.
#pragma once

#include <optional>
#include <string_view>

#include "latex/token/tokens.h"

namespace rigor {

/// `[` for `lbrack`, `:` for `colon`; its text is a literal. Nothing for other controls.
[[nodiscard]] std::optional<Token> sign_named(std::string_view control);

/// `\mathop`, `\mathbin` …
[[nodiscard]] bool is_spacing_class(std::string_view control);
/// Nothing but spaces, or an upright d with them.
[[nodiscard]] bool holds_no_more_than_differential(TokenView content);

}  // namespace rigor
