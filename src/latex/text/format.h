// SPDX-License-Identifier: GPL-3.0-or-later
// What notes are written in.
#pragma once

#include <cstdint>
#include <string_view>

namespace rigor {

enum class Format : std::uint8_t { markdown, latex };

/// `.tex`, `.ltx`, `.latex`, `.sty` are LaTeX; everything else is Markdown.
[[nodiscard]] Format format_of(std::string_view path);

}  // namespace rigor
