// SPDX-License-Identifier: GPL-3.0-or-later
// Mathematics as MathML Core, which browsers draw themselves. Well-formed XML whatever was typed; no network,
// no class but `struck` and `framed`. HTML takes it as it is (XHTML wants its namespace). Typefaces are
// written as Unicode's mathematical letters.
#pragma once

#include <string>
#include <string_view>

#include "latex/layout/layout.h"

namespace rigor {

enum class MathStyle : std::uint8_t { inline_, display };

/// `<math …>…</math>` on one line.
[[nodiscard]] std::string to_mathml(const Box& box, MathStyle style);

/// Of one side or statement; tokens after `expand`.
[[nodiscard]] std::string to_mathml(TokenView tokens, MathStyle style);

/// `A` as 𝐀: the letter or digit in a typeface; as it is where Unicode has no such letter.
[[nodiscard]] std::string in_typeface(std::string_view text, Typeface face);

}  // namespace rigor
