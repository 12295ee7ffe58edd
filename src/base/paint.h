// SPDX-License-Identifier: GPL-3.0-or-later
// Colour on a terminal, by what is meant.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

enum class Paint : std::uint8_t { plain, strong, good, bad, open, faint, mark };

/// The text between a paint's escape sequences; the text alone where `color` is false or the paint is plain.
[[nodiscard]] std::string paint(std::string_view text, Paint style, bool color);

}  // namespace rigor
