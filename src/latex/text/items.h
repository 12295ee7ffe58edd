// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as a list of what matters to a checker, in the order in which it is in the text: headings,
// displayed equations, directive lines, macro definitions. Prose and inline mathematics (`$…$`, `\(…\)`) are
// passed over.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/span.h"

namespace rigor {

struct Heading {
  Span span;
  int level = 1;      // 1 is the outermost: `#`, and in LaTeX the highest that the notes use
  std::string title;  // as written, blanks trimmed, without braces around it
};

/// One line of a directive, without the comment mark and the word `rigor:`, blanks trimmed, e.g. `vector
/// \mathbf{A}`; never empty. Those that are inside a display come before it.
struct DirectiveLine {
  Span span;
};

/// A displayed equation, never empty. `body` is what is between the delimiters; for
/// `\begin{align}…\end{align}` the environment's name is kept (`align*` with its star), for `$$`, `\[` and a
/// math fence it is empty. An argument of the environment, as in `alignat`, is not part of the body.
struct Display {
  Span span;
  Span body;
  std::string environment;
  std::uint32_t quotes = 0;  // marks `>` before each line of the body, for `lex`
  bool cyclic = false;       // the prose right after it goes on with "and cyclic permutations" or "etc."
};

/// A definition such as `\newcommand{\v}[1]{\mathbf{#1}}` outside any display: to be run through `expand`.
struct MacroText {
  Span span;
  bool global = false;         // \gdef, \global: outlives the groups around it
  bool quiet = false;          // of a package: what is not read in it is no mistake of the notes
  std::string_view made = {};  // the definition, where what is at `span` says it in another form
};

/// LaTeX: a group in which macros are defined begins before the first of them, or it ends.
struct MacroGroup {
  Span span;
  bool opens = true;
};

using Item = std::variant<Heading, DirectiveLine, Display, MacroText, MacroGroup>;

struct Document {
  FileId file = 0;
  std::vector<Item> items;
};

}  // namespace rigor
