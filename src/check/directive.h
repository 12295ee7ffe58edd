// SPDX-License-Identifier: GPL-3.0-or-later
// A directive line taken apart: what it does, and the mathematics it does it to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "latex/macros.h"
#include "latex/split.h"
#include "source/diagnostic.h"

namespace rigor {

enum class DirectiveKind : std::uint8_t {
  vector,
  scalar,
  tensor,
  particles,
  constant,
  let,
  given,
  claim,
  expect,
  skip
};

/// One side of a chain after parsing, and a chain of them.
struct ParsedChain {
  WrittenChain written;
  std::vector<SyntaxId> sides;
};

struct Directive {
  DirectiveKind kind = DirectiveKind::skip;
  Span span;
  std::size_t number = 0;  // in the file, for "was it used?"
  bool symmetric = false;
  bool unit = false;
  std::vector<SyntaxId> symbols;    // vector, scalar, tensor, particles, constant
  std::vector<ParsedChain> chains;  // let, given, claim
  std::string text;                 // as written, without comment
};

/// Nothing where the line cannot be read (with a diagnostic), or holds only a comment.
[[nodiscard]] std::optional<Directive> read_directive(const SourceMap& sources, Span line, MacroTable& macros,
                                                      SyntaxTree& syntax, Diagnostics& diagnostics);

/// Splits and parses; used for displays as well.
[[nodiscard]] std::vector<ParsedChain> parse_chains(TokenView tokens, std::string_view environment,
                                                    SyntaxTree& syntax, Diagnostics& diagnostics);

/// The line without `# …` at its end and without blanks around it.
[[nodiscard]] Span without_comment(const SourceMap& sources, Span line);

}  // namespace rigor
