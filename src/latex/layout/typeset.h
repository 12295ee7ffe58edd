// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes as LaTeX that compiles with amsmath and amssymb alone, whatever was typed: a control that is not
// known is words, and no macro of the author is used. Long equations are cut into lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "latex/layout/layout.h"

namespace rigor {

/// For between dollar signs.
[[nodiscard]] std::string to_typeset(const Box& box);

/// About how wide it is set, in em of the surrounding text.
[[nodiscard]] double typeset_width(const Box& box);

/// The parts of a row in lines of at most about `width` em where there is a sign at which it can be cut:
/// before relations, and before + and − where what is between two relations is too wide. Nothing inside a
/// part is cut.
[[nodiscard]] std::vector<Box> broken_lines(const Box& box, double width);

/// Words as they may be in a paragraph of LaTeX; a character that its fonts lack is named by its number.
[[nodiscard]] std::string typeset_words(std::string_view words);

/// The same in a typewriter face, blanks kept: for source that cannot be set.
[[nodiscard]] std::string typeset_source(std::string_view source);

}  // namespace rigor
