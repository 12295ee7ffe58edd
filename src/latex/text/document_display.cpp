// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/document_display.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.h"
#include "latex/text/prose.h"

namespace rigor {
namespace {

using enum DisplayDelimiter;
using Outcome = DisplayEnd::Outcome;

class DisplaySearch {
 public:
  DisplaySearch(const NotesText& text, const EnvironmentAliases& aliases, DisplayDelimiter delimiter,
                std::string_view environment, std::size_t from, std::size_t limit)
      : text_(text),
        aliases_(aliases),
        delimiter_(delimiter),
        environment_(environment),
        at_(from),
        limit_(std::min(limit, text.size())) {
    const bool markdown = text.format() == Format::markdown;
    // Markdown finds `$$` and `\]` before TeX sees a comment.
    has_comments_ = !markdown || delimiter == DisplayDelimiter::environment;
  }

  DisplayEnd result() {
    while (!found_ && at_ < limit_) {
      if (braces_of_words_ > 0) {
        step_in_words();
      } else {
        step();
      }
    }
    if (!found_) {
      at_ = blank_.value_or(limit_);
      stop(Outcome::open, at_);
    }
    return std::move(result_);
  }

 private:
  void step() {
    switch (text_[at_]) {
      case '\\':
        read_control();
        break;
      case '$':
        read_dollar();
        break;
      case '\n':
        read_line_break();
        break;
      case '%':
        at_ = has_comments_ ? text_.line_end(at_) : at_ + 1;
        break;
      default:
        ++at_;
    }
  }

  void stop(Outcome outcome, std::size_t end) {
    result_.outcome = outcome;
    result_.begin = at_;
    result_.end = end;
    found_ = true;
  }

  /// In the braces of an \intertext, which end at a blank line at the latest.
  void step_in_words() {
    const char c = text_[at_];
    const std::size_t begin = at_++;
    if (c == '{') ++braces_of_words_;
    if (c == '}') --braces_of_words_;
    if (c == '%' && has_comments_) at_ = text_.line_end(begin);
    if (c == '\n' && text_.is_blank_line(at_)) braces_of_words_ = 0;
    if (c == '$' && text_[at_] == '$') pass(begin);
    if (c != '\\') return;
    const std::string_view word = text_.control_word(begin);
    at_ = std::min(begin + 1 + std::max<std::size_t>(word.size(), 1), text_.size());
    const auto mark = word == "begin" ? text_.environment_mark(at_) : std::nullopt;
    if (text_[begin + 1] == '[' || aliases_.begins.contains(word) || (mark && opens_display(mark->name)))
      pass(begin);
  }

  [[nodiscard]] bool opens_display(std::string_view name) const {
    return is_display_environment(name) || aliases_.environments.contains(name);
  }

  void pass(std::size_t display) {
    if (!result_.passed) result_.passed = display;
  }

  void read_dollar() {
    if (text_[at_ + 1] != '$') {
      ++at_;
    } else if (delimiter_ == dollars && (!blank_ || surely_closes(at_ + 2))) {
      stop(Outcome::closed, at_ + 2);
    } else {
      at_ = blank_.value_or(at_);
      stop(Outcome::open, at_ + 2);
    }
  }

  void read_line_break() {
    ++at_;
    const bool markdown = text_.format() == Format::markdown;
    const bool blank = text_.is_blank_line(at_);
    const bool block = markdown && begins_block(at_);
    if (!block) {
      if (!blank || delimiter_ == DisplayDelimiter::environment) return;
      if (markdown ? goes_on_below(at_) : delimiter_ != dollars) return;
    }
    at_ = blank_.value_or(at_);
    stop(Outcome::open, at_);
  }

  [[nodiscard]] bool begins_block(std::size_t line) const {
    static constexpr auto marks =
        std::to_array<std::string_view>({"```", "~~~", ":::", "---", "===", "***", "<!--"});
    return atx_level(text_, line) > 0 ||
           std::ranges::any_of(marks, [&](std::string_view mark) { return text_.has(mark, line); });
  }

  /// At a blank line: mathematics goes on after it, and is closed.
  bool goes_on_below(std::size_t line) {
    if (line < checked_) return true;
    std::size_t next = line;
    while (next < limit_ && text_.is_blank_line(next)) next = text_.next_line(next);
    checked_ = next;
    if (next >= limit_) return false;
    const std::string_view paragraph = text_.between(next, std::min(text_.blank_line(next), limit_));
    if (begins_block(next) || reads_as_prose(paragraph.substr(0, paragraph.find(closing())))) return false;
    if (!blank_) blank_ = line;
    return true;
  }

  [[nodiscard]] std::string_view closing() const {
    return delimiter_ == dollars ? "$$" : delimiter_ == bracket ? "\\]" : "\\\\]";
  }

  /// `$$` before `behind`, with blank lines between it and the opening: it closes, unless what stands behind
  /// it up to the next `$$` can be a display.
  [[nodiscard]] bool surely_closes(std::size_t behind) const {
    const Span rest = text_.trimmed(behind, text_.line_end(behind));
    const char first = rest.empty() ? '.' : text_[rest.begin];
    const bool alone = first == '{' || first == '(' || first == '.' || first == ',' || first == ';';
    if (!alone) {
      const std::string_view words = text_.between(rest.begin, rest.end);
      return reads_as_prose(words.substr(0, words.find("$$")));
    }
    const std::size_t begin = text_.next_line(behind);
    const std::size_t next = std::min(text_.find("$$", begin), limit_);
    bool mathematics = false;
    for (std::size_t line = begin; line < next && next < limit_;) {
      const std::size_t end = std::min(text_.blank_line(line), next);
      const std::string_view paragraph = text_.between(line, end);
      if (begins_block(line) || reads_as_prose(paragraph)) return true;
      mathematics = mathematics || has_mathematics(paragraph);
      line = end;
    }
    return !mathematics;
  }

  void read_control() {
    const std::string_view word = text_.control_word(at_);
    const char next = text_[at_ + 1];
    if (!word.empty()) {
      read_word(word);
    } else if (next == ']' && delimiter_ == bracket) {
      stop(Outcome::closed, at_ + 2);
    } else if (next == '[' && (delimiter_ == bracket || delimiter_ == DisplayDelimiter::environment)) {
      stop(Outcome::open, at_);
    } else if (next == '\\' && text_[at_ + 2] == ']' && delimiter_ == double_bracket) {
      stop(Outcome::closed, at_ + 3);
    } else {
      at_ = std::min(at_ + (next == '\n' ? 1 : 2), text_.size());
    }
  }

  void read_word(std::string_view word) {
    const std::size_t behind = at_ + 1 + word.size();
    if (word == "intertext" || word == "shortintertext") {
      const std::size_t brace = text_.skip_gap(behind);
      if (text_[brace] == '{' && delimiter_ == DisplayDelimiter::environment) {
        braces_of_words_ = 1;
        at_ = brace + 1;
        return;
      }
    } else if (word == "begin" || word == "end") {
      if (const auto mark = text_.environment_mark(behind)) {
        word == "begin" ? read_begin(mark->name, mark->end) : read_end(mark->name, mark->end);
        return;
      }
    } else if (const auto begin = aliases_.begins.find(word); begin != aliases_.begins.end()) {
      return read_begin(begin->second.environment, behind);
    } else if (const auto end = aliases_.ends.find(word); end != aliases_.ends.end()) {
      return read_end(end->second, behind);
    } else if (heading_rank(word) >= 0 && delimiter_ != dollars) {
      return stop(Outcome::open, at_);
    }
    at_ = behind;
  }

  void read_begin(std::string_view name, std::size_t behind) {
    if (delimiter_ == DisplayDelimiter::environment && opens_display(name)) {
      return stop(Outcome::open, at_);
    }
    ++depth_;
    at_ = behind;
  }

  /// Environments inside are only counted: whether their names agree is for those who read the display.
  void read_end(std::string_view name, std::size_t behind) {
    if (delimiter_ == DisplayDelimiter::environment && name == environment_) {
      return stop(Outcome::closed, behind);
    }
    if (depth_ == 0 && delimiter_ != dollars) return stop(Outcome::wrong, behind);
    depth_ = std::max(0, depth_ - 1);
    at_ = behind;
  }

  const NotesText& text_;
  const EnvironmentAliases& aliases_;
  DisplayDelimiter delimiter_;
  std::string_view environment_;
  std::size_t at_;
  std::size_t limit_;
  std::optional<std::size_t> blank_ = {};  // the first blank line after which it goes on
  std::size_t checked_ = 0;                // up to here it does
  bool has_comments_;
  int depth_ = 0;
  int braces_of_words_ = 0;
  bool found_ = false;
  DisplayEnd result_;
};

}  // namespace

DisplayEnd find_display_end(const NotesText& text, const EnvironmentAliases& aliases,
                            DisplayDelimiter delimiter, std::string_view environment, std::size_t from,
                            std::size_t limit) {
  return DisplaySearch(text, aliases, delimiter, environment, from, limit).result();
}

int heading_rank(std::string_view control) {
  static constexpr auto headings = std::to_array<std::string_view>(
      {"part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"});
  const auto heading = std::ranges::find(headings, control);
  return heading == headings.end() ? -1 : static_cast<int>(heading - headings.begin());
}

int atx_level(const NotesText& text, std::size_t line) {
  std::size_t at = line;
  while (at < line + 3 && text[at] == ' ') ++at;
  int level = 0;
  for (; text[at] == '#'; ++at) ++level;
  const bool ends = at >= text.size() || is_white(text[at]);
  return level <= 6 && ends ? level : 0;
}

}  // namespace rigor
