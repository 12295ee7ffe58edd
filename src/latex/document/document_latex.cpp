// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/document/document_reader.h"

namespace rigor {
namespace {

/// Something that says more than what macros mean.
bool is_claim(const Item& item) {
  return std::holds_alternative<Display>(item) || std::holds_alternative<DirectiveLine>(item);
}

class LatexReader : NotesReader {
 public:
  LatexReader(DocumentReading& reading, FileId file, InputFiles& inputs)
      : NotesReader(reading, file, Format::latex), inputs_(inputs) {
    const std::size_t document = text_.find("\\begin{document}", 0);
    const std::string& path = reading.sources.path(file);
    if (path.ends_with(".sty") || path.ends_with(".cls")) {
      preamble_end_ = text_.size();
    } else if (document < text_.size()) {
      preamble_end_ = document;
    }
  }

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
        case '{':
          open_brace();
          break;
        case '}':
          close_brace();
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
      read_group(word);
    }
  }

  void open_brace() {
    const std::string_view control = control_before(at_);
    const bool carried_out = !control.empty() && (at_ < preamble_end_ || carries_out_argument(control));
    reading_.groups.open(carried_out ? GroupMark::argument : GroupMark::brace);
    braces_.push_back(control);
    ++at_;
  }

  void close_brace() {
    ++at_;
    close_group(GroupMark::brace);
    if (braces_.empty()) return;
    last_argument_ = {at_, braces_.back()};
    braces_.pop_back();
  }

  /// The control whose argument the brace opens; empty for a brace that stands by itself.
  [[nodiscard]] std::string_view control_before(std::size_t brace) const {
    std::size_t at = brace;
    while (at > 0 && is_blank(text_[at - 1])) --at;
    if (at > 0 && text_[at - 1] == ']') {
      const std::size_t line = at - std::min<std::size_t>(at, 200);
      const auto bracket = text_.between(line, at).rfind('[');
      if (bracket != std::string_view::npos) at = line + bracket;
    }
    if (at == last_argument_.end) return last_argument_.control;
    std::size_t begin = at;
    while (begin > 0 && is_word_letter(text_[begin - 1])) --begin;
    const bool control = begin > 0 && begin < at && text_[begin - 1] == '\\';
    return control ? text_.between(begin, at) : std::string_view();
  }

  /// `\begingroup` and environments; displays have been read before.
  void read_group(std::string_view word) {
    const std::size_t behind = at_ + 1 + word.size();
    const bool environment = word == "begin" || word == "end";
    const auto mark = environment ? text_.environment_mark(behind) : std::nullopt;
    if (mark) {
      at_ = mark->end;
      if (word == "end") return close_group(GroupMark::environment, mark->name);
      return reading_.groups.open(GroupMark::environment, mark->name);
    }
    at_ = behind;
    if (word == "begingroup" || word == "bgroup") reading_.groups.open(GroupMark::begingroup);
    if (word == "endgroup" || word == "egroup") close_group(GroupMark::begingroup);
  }

  void close_group(GroupMark mark, std::string_view name = {}) {
    for (std::size_t k = reading_.groups.close(mark, name, reading_.aliases); k > 0; --k)
      add(MacroGroup{text_.span(at_, at_), false});
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
    if (word == "usepackage" || word == "RequirePackage") return read_packages(at_ + 1 + word.size(), ".sty");
    if (word == "documentclass" || word.starts_with("LoadClass"))
      return read_packages(at_ + 1 + word.size(), ".cls");
    if (word == "endinput") return read_end_of_file();
    if (read_conditional(word) || read_own_verbatim(word)) return true;
    if (const int rank = heading_rank(word); rank >= 0) return read_heading(rank, at_ + 1 + word.size());
    return false;
  }

  bool read_end_of_document() {
    const auto mark = text_.environment_mark(at_ + 4);
    if (!mark || mark->name != "document") return false;
    at_ = text_.size();
    return true;
  }

  bool read_end_of_file() {
    at_ = text_.size();
    return true;
  }

  /// `\lstnewenvironment{code}…`, `\excludecomment{name}`: what is in such an environment is not
  /// displayed.
  bool read_own_verbatim(std::string_view word) {
    static constexpr auto declaring = std::to_array<std::string_view>(
        {"DefineVerbatimEnvironment", "excludecomment", "lstnewenvironment", "newtcblisting", "newverbatim"});
    if (!is_one_of(word, declaring)) return false;
    at_ += 1 + word.size();
    if (const auto mark = text_.environment_mark(at_)) {
      reading_.aliases.verbatims.emplace(mark->name);
      at_ = mark->end;
    }
    return true;
  }

  bool read_verbatim_environment() {
    const auto mark = text_.environment_mark(at_ + 6);
    if (!mark || !(is_verbatim_environment(mark->name) || reading_.aliases.verbatims.contains(mark->name)))
      return false;
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

  /// A conditional begins, goes on with another branch or ends, or a switch is declared or turned.
  bool read_conditional(std::string_view word) {
    const std::size_t behind = at_ + 1 + word.size();
    if (word == "newif") {
      const std::size_t name = text_.skip_gap(behind);
      const std::string_view control = text_[name] == '\\' ? text_.control_word(name) : std::string_view();
      if (control.starts_with("if")) reading_.switches.declare(control.substr(2));
      at_ = control.empty() ? behind : name + 1 + control.size();
      return true;
    }
    if (word == "else" || word == "or") return read_other_branch(behind);
    if (word == "fi" && !conditionals_.empty()) conditionals_.pop_back();
    if (word == "fi" || reading_.switches.turn(word)) {
      at_ = behind;
      return true;
    }
    if (!opens_conditional(word)) return false;
    const auto value = reading_.switches.value(word);
    if (value.value_or(true)) {
      conditionals_.push_back(value.has_value());
      at_ = behind;
    } else {
      skip_branch(behind, false);
    }
    return true;
  }

  /// The branch before it counts, or its condition is not known and it was read.
  bool read_other_branch(std::size_t behind) {
    if (conditionals_.empty()) return false;
    const bool known = conditionals_.back();
    conditionals_.pop_back();
    const std::size_t begin = at_;
    skip_branch(behind, true);
    if (!known && opens_display(text_.between(behind, at_))) {
      report_unread(text_.span(begin, behind), "a display in a branch that may not be typeset is not read",
                    "`\\iftrue`, `\\iffalse` or a switch of `\\newif` says which branch counts");
    }
    return true;
  }

  void skip_branch(std::size_t behind, bool to_fi) {
    const auto end = endless_.contains("\\fi") ? std::nullopt : find_branch_end(text_, behind, to_fi);
    if (!end) {
      endless_.insert("\\fi");
      return report_block(behind, "\\fi");
    }
    at_ = end->end;
    if (!end->at_fi) conditionals_.push_back(true);
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

  /// `\usepackage[options]{a,b}`: of files beside the notes, what they define.
  bool read_packages(std::size_t at, std::string_view extension) {
    at = text_.skip_gap(at);
    const auto options = text_[at] == '[' ? text_.bracket_end(at) : std::optional(at);
    const std::size_t open = options ? text_.skip_gap(*options) : at;
    const auto close = text_[open] == '{' ? text_.group_end(open, true) : std::nullopt;
    if (!close) return false;
    const Span place = text_.span(at_, *close);
    at_ = *close;
    for (std::size_t begin = open + 1; begin < *close;) {
      const std::string_view rest = text_.between(begin, *close - 1);
      const std::size_t length = std::min(rest.find(','), rest.size());
      const Span name = text_.trimmed(begin, begin + length);
      const auto file = inputs_.open_package(text_.between(name.begin, name.end), extension, place);
      if (file) {
        read_package(reading_, *file, inputs_);
        inputs_.close(false);
      }
      begin += length + 1;
    }
    return true;
  }

  struct ArgumentEnd {
    std::size_t end = 0;
    std::string_view control = {};  // empty: of a group
  };

  InputFiles& inputs_;
  std::size_t preamble_end_ = 0;
  std::set<std::string, std::less<>> endless_;  // closings that do not come any more
  std::vector<bool> conditionals_;              // those around: is it known which branch counts?
  std::vector<std::string_view> braces_;        // those that are open: the controls whose arguments they hold
  ArgumentEnd last_argument_;
};

}  // namespace

void read_latex(DocumentReading& reading, FileId file, InputFiles& inputs) {
  LatexReader(reading, file, inputs).read();
}

/// A package is a program: of all that is in it, only what it defines is taken, and nothing in it is a
/// mistake of the notes.
void read_package(DocumentReading& reading, FileId file, InputFiles& inputs) {
  Diagnostics unheard;
  DocumentReading own{reading.sources, unheard, {}, std::move(reading.aliases)};
  const auto heard = static_cast<std::ptrdiff_t>(reading.diagnostics.size());
  LatexReader(own, file, inputs).read();
  reading.diagnostics.erase(reading.diagnostics.begin() + heard, reading.diagnostics.end());  // of `inputs`
  reading.aliases = std::move(own.aliases);
  int open = 0;
  for (Item& item : own.document.items) {
    if (auto* const macro = std::get_if<MacroText>(&item)) macro->quiet = true;
    const auto* const group = std::get_if<MacroGroup>(&item);
    if (group != nullptr) open += group->opens ? 1 : -1;
    if (group != nullptr || std::holds_alternative<MacroText>(item))
      reading.document.items.push_back(std::move(item));
  }
  const auto size = static_cast<std::uint32_t>(reading.sources.text(file).size());
  for (; open > 0; --open) reading.document.items.emplace_back(MacroGroup{{file, size, size}, false});
}

}  // namespace rigor
