// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document_display.h"

#include <algorithm>
#include <array>
#include <utility>

#include "latex/ascii.h"

namespace rigor {
namespace {

using enum DisplayDelimiter;
using Outcome = DisplayEnd::Outcome;

class DisplaySearch {
 public:
  DisplaySearch(const NotesText& text, const EnvironmentAliases& aliases, DisplayDelimiter delimiter,
                std::string_view environment, std::size_t from)
      : text_(text), aliases_(aliases), delimiter_(delimiter), environment_(environment), at_(from) {
    const bool markdown = text.format() == Format::markdown;
    stops_at_blank_line_ = delimiter == dollars || (markdown && delimiter != DisplayDelimiter::environment);
    // Markdown finds `$$` and `\]` before TeX sees a comment.
    has_comments_ = !markdown || delimiter == DisplayDelimiter::environment;
  }

  DisplayEnd result() {
    while (!found_ && at_ < text_.size()) {
      if (braces_of_words_ > 0) {
        step_in_words();
      } else {
        step();
      }
    }
    if (!found_) stop(Outcome::open, text_.size());
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
    } else {
      stop(delimiter_ == dollars ? Outcome::closed : Outcome::open, at_ + 2);
    }
  }

  void read_line_break() {
    ++at_;
    const bool blank = stops_at_blank_line_ && text_.is_blank_line(at_);
    const bool block = text_.format() == Format::markdown && delimiter_ == DisplayDelimiter::environment &&
                       (text_.has("```", at_) || text_.has("~~~", at_) || atx_level(text_, at_) > 0);
    if (blank || block) stop(Outcome::open, at_);
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
  bool stops_at_blank_line_;
  bool has_comments_;
  int depth_ = 0;
  int braces_of_words_ = 0;
  bool found_ = false;
  DisplayEnd result_;
};

}  // namespace

DisplayEnd find_display_end(const NotesText& text, const EnvironmentAliases& aliases,
                            DisplayDelimiter delimiter, std::string_view environment, std::size_t from) {
  return DisplaySearch(text, aliases, delimiter, environment, from).result();
}

int heading_rank(std::string_view control) {
  static constexpr auto headings = std::to_array<std::string_view>(
      {"part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"});
  const auto heading = std::find(headings.begin(), headings.end(), control);
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
