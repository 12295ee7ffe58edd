// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "base/ascii.h"
#include "base/utf8.h"
#include "latex/token/token.h"

namespace rigor {
namespace {

constexpr std::string_view one_blank = " ";

class Lexer {
 public:
  Lexer(std::string_view text, Span span, std::uint32_t quotes)
      : text_(text.substr(0, span.end)), file_(span.file), at_(span.begin), quotes_(quotes) {}

  std::vector<Token> all() {
    if (at_ == 0 || (at_ <= text_.size() && text_[at_ - 1] == '\n')) skip_quotes();
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_white(c) || c == '%') {
        read_gap(true);
      } else if (c == '\\') {
        read_control();
      } else if (c == '#') {
        read_parameter();
      } else {
        read_character();
      }
    }
    return std::move(tokens_);
  }

 private:
  void add(TokenKind kind, std::string_view text, std::size_t begin) {
    tokens_.push_back(
        {kind, text, {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)}});
  }

  /// White space and comments, together one token at most: TeX's states S (skipping blanks) and N (new line).
  void read_gap(bool keep_space) {
    const std::size_t begin = at_;
    bool space = false;
    bool paragraph = false;
    bool new_line = false;  // nothing but blanks since the last line break
    while (at_ < text_.size() && (is_white(text_[at_]) || text_[at_] == '%')) {
      if (text_[at_] == '%') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        space = space || !new_line;
        paragraph = paragraph || (new_line && text_[at_] == '\n');
      }
      if (at_ == text_.size()) break;
      const bool line_break = text_[at_++] == '\n';
      new_line = new_line || line_break;
      if (line_break) skip_quotes();
    }
    if (paragraph) {
      add(TokenKind::paragraph, one_blank, begin);
    } else if (space && keep_space) {
      add(TokenKind::space, one_blank, begin);
    }
  }

  /// At the start of a line in a quotation: moves after the marks, up to the depth of the quotation.
  void skip_quotes() {
    for (std::uint32_t left = quotes_; left > 0; --left) {
      std::size_t mark = at_;
      while (mark < text_.size() && is_blank(text_[mark])) ++mark;
      if (mark >= text_.size() || text_[mark] != '>') return;
      at_ = mark + 1;
    }
  }

  void read_control() {
    const std::size_t begin = at_++;
    const std::size_t name = at_;
    while (at_ < text_.size() && is_word_letter(text_[at_])) ++at_;
    if (at_ > name) {
      add(TokenKind::control, text_.substr(name, at_ - name), begin);
      read_gap(false);
      return;
    }
    const bool blank = at_ < text_.size() && is_white(text_[at_]);
    skip_code_point();
    add(TokenKind::control, blank ? one_blank : text_.substr(name, at_ - name), begin);
  }

  void read_parameter() {
    const std::size_t begin = at_++;
    const bool numbered = at_ < text_.size() && text_[at_] >= '1' && text_[at_] <= '9';
    if (numbered) ++at_;
    add(TokenKind::parameter, text_.substr(begin + 1, numbered ? 1 : 0), begin);
  }

  void read_character() {
    const std::size_t begin = at_;
    skip_code_point();
    add(kind_of(text_[begin]), text_.substr(begin, at_ - begin), begin);
  }

  /// A stray continuation byte counts as a code point of its own.
  void skip_code_point() {
    if (at_ >= text_.size()) return;
    const bool ascii = static_cast<unsigned char>(text_[at_]) < 0x80U;
    ++at_;
    while (!ascii && at_ < text_.size() && is_continuation(text_[at_])) ++at_;
  }

  static TokenKind kind_of(char c) {
    switch (c) {
      case '{':
        return TokenKind::begin_group;
      case '}':
        return TokenKind::end_group;
      case '^':
        return TokenKind::superscript;
      case '_':
        return TokenKind::subscript;
      case '&':
        return TokenKind::align;
      default:
        break;
    }
    if (is_digit(c)) return TokenKind::digit;
    if (is_letter(c) || static_cast<unsigned char>(c) >= 0x80U) return TokenKind::letter;
    return TokenKind::other;
  }

  std::string_view text_;  // of the file, up to the end of the stretch
  FileId file_;
  std::size_t at_;
  std::uint32_t quotes_;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> lex(const SourceMap& sources, Span span, std::uint32_t quotes) {
  return Lexer(sources.text(span.file), span, quotes).all();
}

std::vector<Token> lex_text(std::string_view text) {
  std::vector<Token> tokens = Lexer(text, {{}, 0, static_cast<std::uint32_t>(text.size())}, 0).all();
  for (Token& token : tokens) token.span = {};
  return tokens;
}

}  // namespace rigor
