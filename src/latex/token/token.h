// SPDX-License-Identifier: GPL-3.0-or-later
// TeX tokens of one stretch of notes. A token's text is a view into the text it was lexed from (for a macro's
// body: the definition); its span is where the author wrote it: for a token that came out of a macro's body,
// the macro call.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "source/source_map.h"

namespace rigor {

enum class TokenKind : std::uint8_t {
  control,      // \alpha, \\, \, : text without the backslash; `\` and white space is the control ` `
  letter,       // one letter a-z, A-Z, or one non-ASCII code point (α, ∑, ·); later, words for a quantity
  digit,        // one digit
  begin_group,  // {
  end_group,    // }
  superscript,  // ^
  subscript,    // _
  align,        // &
  space,        // white space, a run of it (at most one line break); text is one blank
  paragraph,    // white space with two or more line breaks; text is one blank
  parameter,    // #1 … #9 in a macro's body: text is the digit; a stray # has empty text
  other,        // any other single character: + - = ( ) | , . ' < > / * ! ; : [ ] ~ $
};

struct Token {
  TokenKind kind;
  std::string_view text;
  Span span;
  std::uint32_t place = 0;  // which token of its display it is, from 1; 0: it was not typed, or nobody counts
};

/// All tokens of `span`. Comments (% to the end of the line, with the line break and the blanks that follow)
/// vanish, and so do blanks after a control word; `@` is a letter in a control word. `\begin` and `\end` are
/// controls like others; the braces that follow are tokens. In a Markdown quotation, up to `quotes` marks `>`
/// at the start of each line are blanks. Nothing is an error here. Cost: linear.
[[nodiscard]] std::vector<Token> lex(const SourceMap& sources, Span span, std::uint32_t quotes = 0);
/// The same of a text that outlives its tokens and stands in no notes: spans are empty.
[[nodiscard]] std::vector<Token> lex_text(std::string_view text);

}  // namespace rigor
