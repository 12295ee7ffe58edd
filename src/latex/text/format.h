// SPDX-License-Identifier: GPL-3.0-or-later
// What notes are written in.
#pragma once

#include <cstdint>
#include <string_view>

#include "source/source_map.h"

namespace rigor {

enum class Format : std::uint8_t { markdown, latex };

/// The path of what stands in no file.
inline constexpr std::string_view standard_input = "-";

/// `.tex`, `.ltx`, `.latex`, `.sty`, `.cls` are LaTeX; everything else is Markdown.
[[nodiscard]] Format format_of(std::string_view path);
/// The same by the file's path; the standard input's by what stands at the start of its lines.
[[nodiscard]] Format format_of(const SourceMap& sources, FileId file);

}  // namespace rigor
