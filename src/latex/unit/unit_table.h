// SPDX-License-Identifier: GPL-3.0-or-later
// The units of the SI, those used with it, and their prefixes.
#pragma once

#include <optional>
#include <string_view>

#include "latex/unit/units.h"

namespace rigor {

/// `km`, `N`, `\mu s`.
[[nodiscard]] std::optional<WrittenUnit> unit_by_sign(std::string_view sign);

/// `\kilo\metre` at the start of the text, which is taken off it.
[[nodiscard]] std::optional<WrittenUnit> take_unit_words(std::string_view& text);

}  // namespace rigor
