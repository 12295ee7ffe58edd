// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/document_text.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/ascii.h"

namespace rigor {
namespace {

constexpr int open_groups_searched = 8;
constexpr std::size_t longest_name = 200;  // of an environment

}  // namespace

bool NotesText::has(std::string_view what, std::size_t at) const {
  return at <= text_.size() && text_.substr(at).starts_with(what);
}

Span NotesText::span(std::size_t begin, std::size_t end) const {
  return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

Span NotesText::trimmed(std::size_t begin, std::size_t end) const {
  while (begin < end && is_white(text_[begin])) ++begin;
  while (begin < end && is_white(text_[end - 1])) --end;
  return span(begin, end);
}

std::string_view NotesText::control_word(std::size_t at) const {
  std::size_t end = at + 1;
  while (is_word_letter((*this)[end])) ++end;
  return end > at + 1 ? between(at + 1, end) : std::string_view();
}

std::optional<EnvironmentMark> NotesText::environment_mark(std::size_t at) const {
  while (is_blank((*this)[at])) ++at;
  if ((*this)[at] != '{') return std::nullopt;
  for (std::size_t end = at + 1; end < text_.size() && end - at < longest_name; ++end) {
    if (text_[end] == '\n' || text_[end] == '{' || text_[end] == '\\') return std::nullopt;
    if (text_[end] == '}') return EnvironmentMark{without_blanks_around(between(at + 1, end)), end + 1};
  }
  return std::nullopt;
}

std::size_t NotesText::line_end(std::size_t at) const { return std::min(text_.find('\n', at), text_.size()); }

std::size_t NotesText::next_line(std::size_t at) const { return std::min(line_end(at) + 1, text_.size()); }

bool NotesText::is_blank_line(std::size_t line) const {
  std::size_t at = line;
  while (is_blank((*this)[at]) || (format_ == Format::markdown && (*this)[at] == '>')) ++at;
  return at == text_.size() || text_[at] == '\n';
}

std::size_t NotesText::blank_line(std::size_t at) const {
  std::size_t line = next_line(at);
  while (line < text_.size() && !is_blank_line(line)) line = next_line(line);
  return line;
}

std::size_t NotesText::skip_gap(std::size_t at) const {
  while (at < text_.size()) {
    if (format_ == Format::latex && text_[at] == '%') {
      at = line_end(at);
    } else if (is_blank(text_[at])) {
      ++at;
      continue;
    }
    if (at == text_.size() || text_[at] != '\n' || is_blank_line(at + 1)) return at;
    ++at;
  }
  return at;
}

bool NotesText::goes_on_cyclically(std::size_t at) const {
  static constexpr std::array<std::string_view, 7> beginnings{
      "and cyclic perm",  "and cyclically", "and cyc. perm", "and its cyclic perm",
      "plus cyclic perm", "plus cyclic.",   "etc."};
  at = skip_gap(at);
  while (format_ == Format::markdown && ((*this)[at] == '>' || is_blank((*this)[at]))) ++at;
  if ((*this)[at] == '(' || (*this)[at] == ',') at = skip_gap(at + 1);
  std::string words;
  for (const std::size_t end = std::min(at + 40, text_.size()); at < end; ++at) {
    const char c = text_[at];
    if (!is_white(c)) words += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (is_white(c) && !words.empty() && words.back() != ' ') words += ' ';
    if (c == '\n' && is_blank_line(at + 1)) break;
  }
  return std::ranges::any_of(beginnings,
                             [&](std::string_view beginning) { return words.starts_with(beginning); });
}

std::optional<std::size_t> NotesText::group_end(std::size_t open, bool in_paragraph) {
  in_paragraph = in_paragraph || open_groups_ == open_groups_searched;
  int depth = 0;
  for (std::size_t at = open; at < text_.size(); ++at) {
    const char c = text_[at];
    if (c == '%' && format_ == Format::latex) at = line_end(at);
    if (c == '\\') {
      ++at;
    } else if (in_paragraph && (*this)[at] == '\n' && is_blank_line(at + 1)) {
      break;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return at + 1;
    }
  }
  if (!in_paragraph) ++open_groups_;
  return std::nullopt;
}

std::optional<std::size_t> NotesText::bracket_end(std::size_t open) const {
  int depth = 0;
  for (std::size_t at = open + 1; at < text_.size(); ++at) {
    const char c = text_[at];
    if (c == '%' && format_ == Format::latex) at = line_end(at);
    if (c == '\\') {
      ++at;
    } else if ((*this)[at] == '\n' && is_blank_line(at + 1)) {
      return std::nullopt;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth < 0) {
      return std::nullopt;
    } else if (c == ']' && depth == 0) {
      return at + 1;
    }
  }
  return std::nullopt;
}

}  // namespace rigor
