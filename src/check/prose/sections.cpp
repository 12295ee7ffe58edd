// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/sections.h"

#include <algorithm>
#include <array>

#include "base/ascii.h"

namespace rigor {
namespace {

/// Exercises, examples and theorems. A solution or a proof goes on with what it belongs to, and what stands
/// in a definition is said for the section around it.
bool names_section(const std::string& word) {
  static constexpr std::array<std::string_view, 9> names{
      "exercise", "example", "problem", "theorem", "lemma", "proposition", "corollary", "question", "task"};
  return std::ranges::any_of(names, [&](std::string_view name) { return word == name; });
}

/// What holds in a theorem holds outside of it.
bool is_example(std::string_view name) {
  static constexpr std::array<std::string_view, 5> names{"exercise", "example", "problem", "question",
                                                         "task"};
  return std::ranges::any_of(names, [&](std::string_view each) { return name.starts_with(each); });
}

/// `**Exercise 3.** …`, `\textbf{Example:} …`: does a paragraph begin with the name of a section?
bool begins_named(std::string_view line) {
  constexpr std::string_view bold = "\\textbf{";
  if (line.starts_with(bold)) line.remove_prefix(bold.size());
  while (!line.empty() && (line.front() == '*' || line.front() == '_')) line.remove_prefix(1);
  const auto end = static_cast<std::size_t>(std::ranges::find_if(line, [](char c) { return !is_letter(c); }) -
                                            line.begin());
  if (end == 0 || !names_section(lowered(line.substr(0, end)))) return false;
  std::string_view rest = line.substr(end);
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  return !rest.empty() &&
         (is_digit(rest.front()) || std::string_view(".:*_}(").find(rest.front()) != std::string_view::npos);
}

/// The column after the marker `- `, `* `, `3. `, `b) `, `(iv) ` of a list item; 0 where there is none.
std::size_t behind_marker(std::string_view line, std::size_t at) {
  std::size_t end = at;
  if (end < line.size() && (line[end] == '-' || line[end] == '*' || line[end] == '+')) {
    ++end;
  } else {
    const bool bracket = end < line.size() && line[end] == '(';
    end += bracket ? 1 : 0;
    const std::size_t begin = end;
    while (end < line.size() && end - begin < 3 && is_letter_or_digit(line[end])) ++end;
    const bool number = end > begin && is_digit(line[begin]);
    const bool closed = end < line.size() && (line[end] == ')' || (line[end] == '.' && number));
    if (end == begin || !closed) return 0;
    ++end;
  }
  return end < line.size() && line[end] == ' ' ? end + 1 : 0;
}

/// The name in braces at `at`, or nothing.
std::string_view braced(std::string_view line, std::size_t at) {
  if (at >= line.size() || line[at] != '{') return {};
  const auto end = line.find('}', at);
  return end == std::string_view::npos ? std::string_view{} : line.substr(at + 1, end - at - 1);
}

bool is_list(std::string_view environment) {
  return environment == "itemize" || environment == "enumerate" || environment == "description" ||
         environment == "questions" || environment == "parts";
}

}  // namespace

bool Sections::reaches(std::size_t from, std::size_t at) const {
  while (at != from && at != 0) at = parents_[at];
  return at == from;
}

bool Sections::leaves_an_example(std::size_t from, std::size_t at) const {
  for (; from != 0 && !reaches(from, at); from = parents_[from]) {
    if (examples_[from]) return true;
  }
  return false;
}

std::size_t Sections::open_in(std::size_t parent, bool example) {
  parents_.push_back(parent);
  examples_.push_back(example);
  return parents_.size() - 1;
}

void SectionWalk::open(Kind kind, std::size_t depth, std::string name) {
  const bool example = kind == Kind::named || is_example(name);
  open_.push_back({kind, sections_.open_in(here(), example), depth, std::move(name)});
}

bool SectionWalk::close(Kind kind, std::string_view name) {
  for (std::size_t k = open_.size(); k-- > 0 && open_[k].kind != Kind::heading;) {
    if (open_[k].kind != kind || (!name.empty() && open_[k].name != name)) continue;
    open_.resize(k);
    return true;
  }
  return false;
}

void SectionWalk::heading(int level) {
  const auto depth = static_cast<std::size_t>(level);
  while (!open_.empty() && (open_.back().kind != Kind::heading || open_.back().depth >= depth))
    open_.pop_back();
  open(Kind::heading, depth);
  after_blank_ = true;
}

void SectionWalk::text(std::string_view text, Format format) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
      after_blank_ = true;
      continue;
    }
    format == Format::markdown ? markdown_line(line) : latex_line(line);
    after_blank_ = false;
  }
}

/// Items of one list, and of those inside them, end where the next item begins.
void SectionWalk::item(std::size_t column, std::size_t text_column) {
  while (!open_.empty() && open_.back().kind == Kind::item && open_.back().depth > column) open_.pop_back();
  open(Kind::item, text_column);
}

void SectionWalk::markdown_line(std::string_view line) {
  const std::size_t column = line.find_first_not_of(" \t");
  const std::string_view rest = line.substr(column);
  if (rest.starts_with(":::")) {
    const bool opens = std::ranges::any_of(rest, [](char c) { return is_letter(c); });
    if (opens) {
      open(Kind::fence, 0);
    } else {
      close(Kind::fence);
    }
    return;
  }
  const bool quoted = rest.front() == '>';
  const bool in_quote = std::ranges::any_of(open_, [](const Open& each) { return each.kind == Kind::quote; });
  if (quoted && !in_quote) open(Kind::quote, 0);
  if (quoted) return;
  if (in_quote && after_blank_) close(Kind::quote);
  if (const std::size_t behind = behind_marker(line, column); behind != 0) return item(column, behind);
  if (!after_blank_) return;
  while (!open_.empty() && open_.back().kind == Kind::item && open_.back().depth > column) open_.pop_back();
  if (!begins_named(rest)) return;
  close(Kind::named);
  open(Kind::named, 0);
}

void SectionWalk::latex_line(std::string_view line) {
  const std::size_t column = line.find_first_not_of(" \t");
  if (after_blank_ && begins_named(line.substr(column))) {
    close(Kind::named);
    open(Kind::named, 0);
  }
  constexpr std::string_view begin = "\\begin";
  constexpr std::string_view end = "\\end";
  for (std::size_t at = line.find('\\'); at != std::string_view::npos; at = line.find('\\', at + 1)) {
    const std::string_view rest = line.substr(at);
    if (rest.starts_with(begin)) {
      const std::string name(braced(rest, begin.size()));
      std::string bare = lowered(name);
      if (!bare.empty() && bare.back() == '*') bare.pop_back();
      if (is_list(bare) || names_section(bare)) open(Kind::environment, 0, name);
    } else if (rest.starts_with(end)) {
      close(Kind::environment, braced(rest, end.size()));
    } else if ((rest.starts_with("\\item") && (rest.size() == 5 || !is_letter(rest[5]))) ||
               rest.starts_with("\\question ") || rest.starts_with("\\part ")) {
      while (!open_.empty() && open_.back().kind == Kind::item) open_.pop_back();
      open(Kind::item, 0);
    }
  }
}

}  // namespace rigor
