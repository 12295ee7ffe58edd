// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a text in any of Markdown's dialects: CommonMark's, once the marks of the others are out of
// the way.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "latex/markdown/markdown_blocks.h"
#include "latex/markdown/markdown_lines.h"
#include "latex/markdown/markdown_shape.h"

namespace rigor {

/// Changes `shape` until no marks are left: what is in them shows only then. Fences that nothing closes
/// are added to `open_fences` by their lines, and what is below them is read as if they were not there.
[[nodiscard]] std::vector<MarkdownBlock> blocks_of_dialects(const NotesText& text, const LineStarts& lines,
                                                            MarkdownShape& shape,
                                                            std::set<std::size_t>& open_fences);

}  // namespace rigor
