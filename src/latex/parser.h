// SPDX-License-Identifier: GPL-3.0-or-later
// The recursive descent behind parse_side. Every method reads a stretch of tokens whose end is already known:
// brackets are matched before their contents are read, so that a bracket left open spoils one node and not
// the rest.
#pragma once

#include <optional>
#include <string>

#include "latex/syntax.h"
#include "latex/tokens.h"
#include "latex/vocabulary.h"

namespace rigor {

class Parser {
 public:
  Parser(SyntaxTree& tree, int depth) : tree_(tree), depth_(depth) {}

  /// A sum of terms; `place` is where to point if there is nothing.
  SyntaxId expression(TokenView tokens, Span place);

  /// Where reading is, in the stretch at hand.
  struct Cursor {
    TokenView tokens;
    std::size_t at = 0;
    [[nodiscard]] bool done() const { return at >= tokens.size(); }
    [[nodiscard]] const Token& token() const { return tokens[at]; }
    void skip_spacing();
  };

 private:
  SyntaxId term(Cursor& cursor);
  SyntaxId factor(Cursor& cursor);
  SyntaxId signed_factor(Cursor& cursor);
  SyntaxId primary(Cursor& cursor);
  SyntaxId scripts(Cursor& cursor, SyntaxId base);
  SyntaxId add_primes(SyntaxId base, std::uint8_t primes, Span place);
  SyntaxId add_indices(SyntaxId base, TokenView content, Span place);
  SyntaxId exponent(SyntaxId base, TokenView content, Span place);

  // parser_brackets.cpp
  SyntaxId bracketed(Cursor& cursor);
  SyntaxId bars(Cursor& cursor);
  SyntaxId bracket_contents(TokenView content, Span span);
  SyntaxId environment(Cursor& cursor);
  SyntaxId cases(TokenView body, Span span);
  SyntaxId matrix(TokenView body, Span span, bool determinant);

  // parser_names.cpp
  SyntaxId letter(Cursor& cursor);
  SyntaxId styled(Cursor& cursor, Style style);
  SyntaxId switched(Cursor& cursor, Style style, std::size_t at);
  SyntaxId restyle(SyntaxId inner, Style style, Span span);
  SyntaxId number(Cursor& cursor);

  // parser_controls.cpp
  SyntaxId control(Cursor& cursor);
  SyntaxId annotated(Cursor& cursor);  // \underbrace, \overset
  SyntaxId fraction(Cursor& cursor);
  SyntaxId root(Cursor& cursor);
  SyntaxId big_sum(Cursor& cursor);
  SyntaxId braced_bracket(Cursor& cursor);  // \abs{…}, \norm{…}, \qty(…)

  SyntaxId opaque(Span span, std::string message, DiagnosticKind kind = DiagnosticKind::unsupported,
                  std::vector<std::string> help = {});
  /// Reads an inner stretch one level deeper.
  SyntaxId inner(TokenView tokens, Span place);

  SyntaxTree& tree_;
  int depth_;
};

}  // namespace rigor
