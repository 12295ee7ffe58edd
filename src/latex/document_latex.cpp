// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "latex/ascii.h"
#include "latex/document_reader.h"

namespace rigor {
namespace {

/// Something that says more than what macros mean.
bool is_claim(const Item& item) {
  return std::holds_alternative<Display>(item) || std::holds_alternative<DirectiveLine>(item);
}

class LatexReader : NotesReader {
 public:
  LatexReader(DocumentReading& reading, FileId file, InputFiles& inputs)
      : NotesReader(reading, file, Format::latex), inputs_(inputs) {}

  void read() {
    while (goes_on()) {
      switch (text_[at_]) {
        case '\\':
          read_control();
          break;
        case '$':
          read_dollar();
          break;
        case '%':
          add_directive(at_);
          at_ = text_.line_end(at_);
          break;
        default:
          ++at_;
      }
    }
  }

 private:
  void read_control() {
    const std::string_view word = text_.control_word(at_);
    if (word.empty()) {
      read_symbol(text_[at_ + 1]);
    } else if (!read_block(word) && !read_environment(word, 0) && !read_definition(word)) {
      at_ += 1 + word.size();
    }
  }

  void read_symbol(char symbol) {
    if (symbol == '[') {
      read_display({DisplayDelimiter::bracket, at_, at_ + 2});
    } else if (symbol == '(') {
      read_inline(at_ + 2, "\\)");
    } else if (symbol == ']') {
      report(at_, at_ + 2, "`\\]` closes nothing", "`\\[` is missing before it");
      at_ += 2;
    } else {
      at_ = std::min(at_ + 2, text_.size());
    }
  }

  void read_dollar() {
    if (text_[at_ + 1] == '$') {
      read_display({DisplayDelimiter::dollars, at_, at_ + 2});
    } else {
      read_inline(at_ + 1, "$");
    }
  }

  /// Passes over inline mathematics. `$` inside braces (`\text{if $x$}`) does not close it.
  void read_inline(std::size_t behind, std::string_view closing) {
    int depth = 0;
    for (std::size_t at = behind; at < text_.size(); ++at) {
      const char c = text_[at];
      if (depth <= 0 && text_.has(closing, at)) {
        add_directives(behind, at);
        at_ = at + closing.size();
        return;
      }
      if (c == '%') at = text_.line_end(at);
      if (c == '{') ++depth;
      if (c == '}') --depth;
      if (c == '\\') {
        ++at;
      } else if (text_[at] == '\n' && text_.is_blank_line(at + 1)) {
        break;
      }
    }
    report(at_, behind, fmt::format("`{}` is not closed in its paragraph", text_.between(at_, behind)),
           closing == "$" ? "close it with `$`, or write `\\$` for the sign" : "close it with `\\)`");
    at_ = text_.after_blank_line(at_);
  }

  /// What is not prose, mathematics or a definition.
  bool read_block(std::string_view word) {
    if (word == "begin") return read_verbatim_environment();
    if (word == "end") return read_end_of_document();
    if (word == "verb" || word == "lstinline") return read_verb(at_ + 1 + word.size());
    if (word == "input" || word == "include" || word == "subfile") return read_input(at_ + 1 + word.size());
    if (word == "iffalse") return read_false_branch();
    if (const int rank = heading_rank(word); rank >= 0) return read_heading(rank, at_ + 1 + word.size());
    return false;
  }

  bool read_end_of_document() {
    const auto mark = text_.environment_mark(at_ + 4);
    if (!mark || mark->name != "document") return false;
    at_ = text_.size();
    return true;
  }

  bool read_verbatim_environment() {
    const auto mark = text_.environment_mark(at_ + 6);
    if (!mark || !is_verbatim_environment(mark->name)) return false;
    const std::string closing = fmt::format("\\end{{{}}}", mark->name);
    const std::size_t end = endless_.contains(closing) ? text_.size() : text_.find(closing, mark->end);
    if (end < text_.size()) {
      at_ = end + closing.size();
    } else {
      endless_.insert(closing);
      report_block(mark->end, closing);
    }
    return true;
  }

  void report_block(std::size_t behind, std::string_view closing) {
    report(at_, behind, fmt::format("`{}` is not closed", text_.between(at_, behind)),
           fmt::format("close it with `{}`", closing));
    at_ = text_.after_blank_line(at_);
  }

  /// `\verb|…|` with any sign for `|`, on one line.
  bool read_verb(std::size_t at) {
    if (text_[at] == '*') ++at;
    const std::string_view sign = at < text_.size() ? text_.between(at, at + 1) : std::string_view();
    if (sign.empty() || is_white(sign[0])) return false;
    const std::size_t close = text_.find(sign == "{" ? "}" : sign, at + 1);
    if (close >= text_.size() || text_.between(at, close).find('\n') != std::string_view::npos) return false;
    at_ = close + 1;
    return true;
  }

  /// `\iffalse … \fi`, with conditionals inside.
  bool read_false_branch() {
    const std::string_view opening = "\\iffalse";
    int depth = 0;
    for (std::size_t at = at_; at < text_.size() && !endless_.contains("\\fi"); ++at) {
      if (text_[at] == '%') at = text_.line_end(at);
      if (text_[at] != '\\') continue;
      const std::string_view word = text_.control_word(at);
      if (word.starts_with("if") && word != "iff" && word != "ifthenelse") ++depth;
      if (word == "fi" && --depth == 0) {
        at_ = at + 3;
        return true;
      }
      at += std::max<std::size_t>(word.size(), 1);
    }
    endless_.insert("\\fi");
    report_block(at_ + opening.size(), "\\fi");
    return true;
  }

  bool read_heading(int rank, std::size_t at) {
    if (text_[at] == '*') ++at;
    at = text_.skip_gap(at);
    std::optional<std::size_t> end = at;
    std::size_t open = at;
    if (text_[at] == '[') end = text_.bracket_end(at);
    if (end) open = text_.skip_gap(*end);
    if (end && text_[open] != '{') return false;
    if (end) end = text_.group_end(open, true);
    if (!end) {
      report(at_, open, fmt::format("`{}` is not closed in its paragraph", text_.between(at_, open + 1)),
             "close its braces and brackets");
      at_ = text_.after_blank_line(at_);
      return true;
    }
    const Span title = text_.trimmed(open + 1, *end - 1);
    add(Heading{text_.span(at_, *end), rank + 1, std::string(text_.between(title.begin, title.end))});
    at_ = *end;
    return true;
  }

  /// `\input{name}` or `\input name`. The files are nested at most 16 deep.
  bool read_input(std::size_t at) {
    at = text_.skip_gap(at);
    std::size_t end = at;
    Span name;
    if (text_[at] == '{') {
      const auto group = text_.group_end(at, true);
      if (!group) {
        report_block(at + 1, "}");
        return true;
      }
      end = *group;
      name = text_.trimmed(at + 1, end - 1);
    } else {
      bool quoted = false;  // \input "a name with blanks"
      for (; end < text_.size() && text_[end] != '%' && text_[end] != '\\' && text_[end] != '\n'; ++end) {
        if (!quoted && is_white(text_[end])) break;
        quoted = quoted != (text_[end] == '"');
      }
      name = text_.span(at, end);
    }
    if (name.empty()) return false;
    const Span place = text_.span(at_, end);
    at_ = end;
    if (const auto file = inputs_.open(text_.between(name.begin, name.end), place)) {
      const auto before = static_cast<std::ptrdiff_t>(reading_.document.items.size());
      read_latex(reading_, *file, inputs_);
      const std::vector<Item>& items = reading_.document.items;
      inputs_.close(std::any_of(items.begin() + before, items.end(), is_claim));
    }
    return true;
  }

  InputFiles& inputs_;
  std::set<std::string, std::less<>> endless_;  // closings that do not come any more
};

}  // namespace

void read_latex(DocumentReading& reading, FileId file, InputFiles& inputs) {
  LatexReader(reading, file, inputs).read();
}

}  // namespace rigor
