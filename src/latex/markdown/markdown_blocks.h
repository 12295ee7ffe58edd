// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a Markdown text, as CommonMark has them: what is code, HTML, a heading or text, and in which
// quotations. The only file that knows cmark-gfm, which was chosen because it gives each block its lines;
// md4c gives none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

struct MarkdownBlock {
  enum class Kind : std::uint8_t { text, heading, code, html };
  Kind kind = Kind::text;
  std::size_t first = 0;  // its lines, counted from 0; a fence's and a heading's own lines belong to it
  std::size_t last = 0;
  int level = 0;               // of a heading
  bool fenced = false;         // code that is not indented
  std::uint32_t quotes = 0;    // marks `>` before its lines
  std::size_t quote_last = 0;  // the last line of the outermost quotation, if there is one
};

/// In the order of the text. Blank lines and rules belong to no block. Needs lines that `MarkdownShape` has
/// bared: the library would look for links and emphasis in others, for some of them in quadratic time.
[[nodiscard]] std::vector<MarkdownBlock> markdown_blocks(const std::string& text);

}  // namespace rigor
