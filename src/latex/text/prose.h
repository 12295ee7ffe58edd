// SPDX-License-Identifier: GPL-3.0-or-later
// Words or mathematics? Where a display is not closed before a blank line, what comes after that line says
// whether it goes on.
#pragma once

#include <string_view>

namespace rigor {

/// The text, a paragraph of Markdown or less, is surely not the inside of a display: words stand side by
/// side, a single `$`, code, a link. Cost: linear.
[[nodiscard]] bool reads_as_prose(std::string_view text);
/// A sign that words do not have: a control, a relation, a script.
[[nodiscard]] bool has_mathematics(std::string_view text);

}  // namespace rigor
