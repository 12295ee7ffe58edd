// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "catch.h"
#include "latex/token/token.h"

namespace {

using namespace rigor;

/// The tokens as `kind:text`, with blanks between them; the kind is its first letters.
std::string dump(std::string text, std::uint32_t quotes = 0) {
  static constexpr const char* names[] = {"control", "letter", "digit", "begin",     "end",       "sup",
                                          "sub",     "align",  "space", "paragraph", "parameter", "other"};
  SourceMap sources;
  const auto size = static_cast<std::uint32_t>(text.size());
  const FileId file = sources.add("notes.tex", std::move(text));
  std::string result;
  for (const Token& token : lex(sources, {file, 0, size}, quotes)) {
    if (!result.empty()) result += ' ';
    result += names[static_cast<std::size_t>(token.kind)];
    if (token.kind != TokenKind::space && token.kind != TokenKind::paragraph)
      result += ":" + std::string(token.text);
  }
  return result;
}

}  // namespace

TEST_CASE("a control word ends before the first character that is no letter") {
  CHECK(dump("\\alpha_1") == "control:alpha sub:_ digit:1");
  CHECK(dump("\\a@b") == "control:a@b");
}

TEST_CASE("a control word takes the blanks behind it, a control symbol does not") {
  CHECK(dump("\\cdot  x") == "control:cdot letter:x");
  CHECK(dump("\\cdot\n x") == "control:cdot letter:x");
  CHECK(dump("\\, x") == "control:, space letter:x");
  CHECK(dump("\\cdot % remark\n  x") == "control:cdot letter:x");
}

TEST_CASE("a control symbol is one character") {
  CHECK(dump("\\\\[2pt]") == "control:\\ other:[ digit:2 letter:p letter:t other:]");
  CHECK(dump("\\{\\|\\%") == "control:{ control:| control:%");
  CHECK(dump("\\\n") == "control: ");
  CHECK(dump("\\α") == "control:α");
}

TEST_CASE("a comment vanishes with its line break and the blanks behind it") {
  CHECK(dump("a% b\n  c") == "letter:a letter:c");
  CHECK(dump("a % b\n  c") == "letter:a space letter:c");
  CHECK(dump("a %") == "letter:a space");
  CHECK(dump("a\n% b\nc") == "letter:a space letter:c");
}

TEST_CASE("a blank line ends a paragraph, also behind a comment and a control word") {
  CHECK(dump("a\n \nb") == "letter:a paragraph letter:b");
  CHECK(dump("a % b\n\nc") == "letter:a paragraph letter:c");
  CHECK(dump("\\cdot\r\n\r\nc") == "control:cdot paragraph letter:c");
}

TEST_CASE("a code point beyond ASCII is one letter") {
  CHECK(dump("α·∑") == "letter:α letter:· letter:∑");
  CHECK(dump("\x80\xCE") == "letter:\x80 letter:\xCE");
}

TEST_CASE("a parameter has its digit, a stray mark has none") {
  CHECK(dump("#1#x##2") == "parameter:1 parameter: letter:x parameter: parameter:2");
}

TEST_CASE("each sign of TeX has its kind") {
  CHECK(dump("{^_&}~$") == "begin:{ sup:^ sub:_ align:& end:} other:~ other:$");
}

TEST_CASE("a lone backslash at the end is a control without a name") {
  CHECK(dump("a\\") == "letter:a control:");
}

TEST_CASE("the marks of a quotation are blanks at the start of a line, and only as many as there are") {
  CHECK(dump("> a\n> > b", 1) == "space letter:a space other:> space letter:b");
  CHECK(dump("a > b\n>c", 1) == "letter:a space other:> space letter:b space letter:c");
  CHECK(dump("a\n> b") == "letter:a space other:> space letter:b");
}

TEST_CASE("a span is where the token was written") {
  SourceMap sources;
  const FileId file = sources.add("notes.tex", "x \\mathbf  {α}");
  const auto tokens = lex(sources, {file, 2, 15});
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[0].span == Span{file, 2, 9});
  CHECK(tokens[2].span == Span{file, 12, 14});
  CHECK(sources.text(tokens[2].span) == "α");
}

TEST_CASE("no bytes disturb the lexer") {
  std::uint32_t state = 1;
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (int i = 0; i < 200; ++i) {
      state = state * 1664525U + 1013904223U;
      const char any = static_cast<char>(state >> 24U);
      text += round % 2 == 0 ? any : "\\%{}#\n >a\xCE"[(state >> 24U) % 10];
    }
    SourceMap sources;
    const FileId file = sources.add("notes.tex", text);
    std::uint32_t last = 0;
    bool in_order = true;
    for (const Token& token : lex(sources, {file, 0, 200}, 1)) {
      in_order =
          in_order && token.span.begin >= last && token.span.end > token.span.begin && token.span.end <= 200;
      last = token.span.end;
    }
    CHECK(in_order);
  }
}
