// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "latex/ascii.h"
#include "latex/document_reader.h"
#include "latex/markdown_lines.h"

namespace rigor {
namespace {

/// Searches for a closing mark that end in nothing, before they are given up.
constexpr int failures_searched = 8;

class MarkdownReader : NotesReader {
 public:
  MarkdownReader(DocumentReading& reading, FileId file) : NotesReader(reading, file, Format::markdown) {}

  void read() {
    at_ = front_matter_end(text_);
    while (goes_on()) read_line();
  }

 private:
  void read_line() {
    const std::size_t line = at_;
    line_ = line_start(text_, line);
    const std::size_t above = std::exchange(text_above_, text_.size());
    if (text_.is_blank_line(line)) {
      at_ = text_.next_line(line);
    } else if (const auto fence = fence_at(text_, line_.at)) {
      read_fence(*fence);
    } else if (const int level = atx_level(text_, line); level > 0) {
      add_heading(line, text_.line_end(line), level, atx_title(text_, line));
    } else if (const int setext = setext_level(text_, line); setext > 0 && above < line) {
      add_heading(above, text_.line_end(line), setext, text_.trimmed(above, line));
    } else {
      text_above_ = line_.marked ? text_.size() : line;
      read_text();
    }
  }

  void add_heading(std::size_t begin, std::size_t end, int level, Span title) {
    add(Heading{text_.span(begin, end), level, std::string(text_.between(title.begin, title.end))});
    at_ = text_.next_line(end);
  }

  /// To the end of the line, or of what reaches beyond it.
  void read_text() {
    do {
      switch (text_[at_]) {
        case '\n':
          ++at_;
          return;
        case '\\':
          read_backslash();
          break;
        case '$':
          read_dollar();
          break;
        case '`':
          read_code_span();
          break;
        case '<':
          read_angle();
          break;
        default:
          ++at_;
      }
    } while (goes_on() && text_[at_ - 1] != '\n');
  }

  /// A display in the text: no heading is made of its lines.
  void read_text_display(DisplayDelimiter delimiter, std::size_t length) {
    text_above_ = text_.size();
    read_display({delimiter, at_, at_ + length, {}, line_.quotes});
  }

  /// Markdown writes `\[` for a plain bracket: inside a line that is what stands there, unless it is closed.
  void read_bracket(DisplayDelimiter delimiter, std::size_t length) {
    if (at_ == line_.at) return read_text_display(delimiter, length);
    std::size_t& not_before = no_bracket_before_[delimiter == DisplayDelimiter::bracket ? 0 : 1];
    if (at_ >= not_before) {
      const auto end = read_closed_display({delimiter, at_, at_ + length, {}, line_.quotes});
      if (end.outcome == DisplayEnd::Outcome::closed) {
        text_above_ = text_.size();
        return;
      }
      not_before = end.begin;
    }
    at_ += length;
  }

  void read_backslash() {
    const std::string_view word = text_.control_word(at_);
    if (!word.empty()) {
      if (read_environment(word, line_.quotes)) {
        text_above_ = text_.size();
      } else if (!read_definition(word)) {
        at_ += 1 + word.size();
      }
    } else if (text_.has("\\\\[", at_)) {
      read_bracket(DisplayDelimiter::double_bracket, 3);
    } else if (text_.has("\\[", at_)) {
      read_bracket(DisplayDelimiter::bracket, 2);
    } else if (text_.has("\\\\(", at_)) {
      read_parenthesis(3, "\\\\)");
    } else if (text_.has("\\(", at_)) {
      read_parenthesis(2, "\\)");
    } else {
      at_ = std::min(at_ + (text_[at_ + 1] == '\n' ? 1 : 2), text_.size());
    }
  }

  /// Inline mathematics, or a plain parenthesis where it is not closed.
  void read_parenthesis(std::size_t length, std::string_view closing) {
    const std::size_t begin = at_ + length;
    at_ = begin;
    const std::size_t end = paragraph_end();
    if (begin < no_parenthesis_before_ || begin > end) return;
    const auto close = text_.between(begin, end).find(closing);
    if (close == std::string_view::npos) {
      no_parenthesis_before_ = end;
    } else {
      pass_inline(begin, begin + close, closing.size());
    }
  }

  void read_dollar() {
    if (text_[at_ + 1] == '$') return read_text_display(DisplayDelimiter::dollars, 2);
    const std::size_t begin = at_ + 1;
    at_ = begin;
    if (begin < no_dollar_before_ || begin >= text_.size() || is_white(text_[begin])) return;
    std::size_t at = begin;
    for (const std::size_t end = paragraph_end(); at < end; ++at) {
      if (text_[at] == '\\') ++at;
      if (text_[at] != '$') continue;
      const bool after_blank = is_white(text_[at - 1]);
      if (after_blank && text_[at + 1] == '$') break;
      if (!after_blank && !is_digit(text_[at + 1])) return pass_inline(begin, at, 1);
    }
    no_dollar_before_ = at;
  }

  /// Stands behind inline mathematics. Only definitions count in it: notes that KaTeX shows begin with
  /// `$\newcommand…$`.
  void pass_inline(std::size_t begin, std::size_t end, std::size_t closing_length) {
    for (at_ = begin; at_ < end;) {
      if (text_[at_] != '\\') {
        ++at_;
        continue;
      }
      const std::string_view word = text_.control_word(at_);
      if (!word.empty() && read_definition(word)) continue;
      at_ += std::max<std::size_t>(word.size(), 1) + 1;
    }
    at_ = std::max(at_, end + closing_length);
  }

  /// `` `…` ``, closed by as many marks as opened it; else the marks are text.
  void read_code_span() {
    const std::size_t begin = at_;
    while (text_[at_] == '`') ++at_;
    const std::size_t marks = at_ - begin;
    const std::size_t end = paragraph_end();
    if (open_code_spans_ == failures_searched) return;
    for (std::size_t at = at_; at < end; ++at) {
      if (text_[at] != '`') continue;
      std::size_t behind = at;
      while (text_[behind] == '`') ++behind;
      if (behind - at == marks) {
        at_ = behind;
        return;
      }
      at = behind;
    }
    ++open_code_spans_;
  }

  /// Where inline marks must have been closed; looked for once in a paragraph.
  std::size_t paragraph_end() {
    if (at_ >= paragraph_end_) {
      paragraph_end_ = rigor::paragraph_end(text_, at_);
      open_code_spans_ = 0;
    }
    return paragraph_end_;
  }

  void read_angle() {
    const std::string_view opening = "<!--";
    const std::string_view closing = "-->";
    if (!text_.has(opening, at_)) {
      ++at_;
      return;
    }
    const std::size_t begin = at_ + opening.size();
    const std::size_t end = comments_close_ ? text_.find(closing, begin) : text_.size();
    if (end < text_.size()) {
      add_comment_directives(begin, end);
      at_ = end + closing.size();
    } else {
      comments_close_ = false;
      report(at_, begin, "`<!--` is not closed", "close the comment with `-->`");
      at_ = text_.after_blank_line(at_);
    }
  }

  /// `<!-- rigor: … -->`: each line that is not empty.
  void add_comment_directives(std::size_t begin, std::size_t end) {
    constexpr std::string_view word = "rigor:";
    begin = text_.trimmed(begin, end).begin;
    if (!text_.has(word, begin)) return;
    for (std::size_t line = begin + word.size(); line < end;) {
      const std::size_t line_end = line + std::min(text_.between(line, end).find('\n'), end - line);
      const bool quoted = line_.quotes > 0 && text_[line - 1] == '\n';
      const std::size_t from = quoted ? std::min(line_start(text_, line).at, line_end) : line;
      const Span directive = text_.trimmed(from, line_end);
      if (!directive.empty()) add(DirectiveLine{directive});
      line = line_end + 1;
    }
  }

  void read_fence(const Fence& fence) {
    const std::size_t first = text_.next_line(fence.begin);
    const auto closing = find_fence_end(text_, fence, first, open_fences_ >= failures_searched);
    if (!closing) {
      ++open_fences_;
      const std::string_view marks = text_.between(fence.begin, fence.begin + fence.marks);
      report(fence.begin, text_.trimmed(fence.begin, text_.line_end(fence.begin)).end,
             "a fenced block is not closed", fmt::format("close it with a line `{}`", marks));
      at_ = text_.after_blank_line(fence.begin);
      return;
    }
    if (fence.math) {
      add_directives(first, *closing);
      const Span whole = text_.trimmed(fence.begin, text_.line_end(*closing));
      const bool empty = text_.trimmed(first, *closing).empty();
      if (!empty) {
        const bool cyclic = text_.goes_on_cyclically(text_.line_end(*closing));
        add(Display{whole, text_.span(first, *closing), {}, line_.quotes, cyclic});
      }
    }
    at_ = text_.next_line(*closing);
  }

  LineStart line_;                                         // of the line that is being read
  std::size_t text_above_ = static_cast<std::size_t>(-1);  // a line of plain text directly above, or the end
  std::size_t paragraph_end_ = 0;
  std::size_t no_dollar_before_ = 0;                // nothing up to there closes inline mathematics
  std::size_t no_parenthesis_before_ = 0;           // the same for `\)`
  std::array<std::size_t, 2> no_bracket_before_{};  // the same for `\]` and `\\]`
  int open_code_spans_ = 0;                         // in this paragraph
  int open_fences_ = 0;
  bool comments_close_ = true;
};

}  // namespace

void read_markdown(DocumentReading& reading, FileId file) { MarkdownReader(reading, file).read(); }

}  // namespace rigor
