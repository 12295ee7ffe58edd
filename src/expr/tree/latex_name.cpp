// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/latex_name.h"

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

constexpr std::string_view faces[] = {"mathbf",
                                      "boldsymbol",
                                      "bm",
                                      "pmb",
                                      "vec",
                                      "overrightarrow",
                                      "vb",
                                      "va",
                                      "vectorbold",
                                      "vectorarrow",
                                      "mathbfit",
                                      "symbf",
                                      "symbfit",
                                      "bold",
                                      "vv",
                                      "underline",
                                      "overleftrightarrow",
                                      "tensor",
                                      "mathsf",
                                      "mathbfsf"};

/// After the control word whose backslash is at `at`.
std::size_t behind_word(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  return end;
}

/// After the group or the one sign at `at`.
std::size_t behind_argument(std::string_view text, std::size_t at) {
  if (at >= text.size()) return at;
  if (text[at] == '\\') return behind_word(text, at);
  if (text[at] != '{') return at + 1;
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) return at + 1;
  }
  return at;
}

bool is_face(std::string_view word) { return is_one_of(word, faces); }

std::string_view inside_braces(std::string_view argument) {
  const bool braces = argument.size() >= 2 && argument.front() == '{' && argument.back() == '}';
  return braces ? argument.substr(1, argument.size() - 2) : argument;
}

/// The first `_` or `'` outside all braces.
std::size_t tail_of(std::string_view name) {
  int depth = 0;
  for (std::size_t at = 0; at < name.size(); ++at) {
    if (name[at] == '{') ++depth;
    if (name[at] == '}') --depth;
    if (depth == 0 && (name[at] == '_' || name[at] == '\'')) return at;
  }
  return name.size();
}

bool ends_with_word(std::string_view text) {
  std::size_t at = text.size();
  while (at > 0 && is_letter(text[at - 1])) --at;
  return at > 0 && at < text.size() && text[at - 1] == '\\';
}

}  // namespace

bool LatexName::has_bare_label() const {
  for (std::size_t at = 0; at < labels.size();) {
    if (labels[at] != '\\') {
      if (is_letter_or_digit(labels[at])) return true;
      ++at;
      continue;
    }
    at = behind_word(labels, at);
    if (at < labels.size() && labels[at] == '{') at = behind_argument(labels, at);
  }
  return false;
}

LatexName latex_name(std::string_view name) {
  LatexName parts;
  std::size_t at = tail_of(name);
  parts.letter = name.substr(0, at);
  const bool behind = parts.letter.ends_with("{}");
  if (behind) parts.letter.resize(parts.letter.size() - 2);
  while (at < name.size() && name[at] == '\'') parts.primes += name[at++];
  if (behind) {
    parts.behind = "{}" + std::string(name.substr(at));
  } else if (at < name.size() && name[at] == '_') {
    const std::size_t end = behind_argument(name, at + 1);
    parts.labels = inside_braces(name.substr(at + 1, end - at - 1));
    parts.behind = name.substr(end);
  } else {
    parts.behind = name.substr(at);  // `V'(r_0)`
  }
  return parts;
}

std::string without_face(std::string_view letter) {
  std::string plain;
  for (std::size_t at = 0; at < letter.size();) {
    if (letter[at] != '\\') {
      append_latex(plain, letter.substr(at, 1));
      ++at;
      continue;
    }
    std::size_t end = behind_word(letter, at);
    const std::string_view word = letter.substr(at + 1, end - at - 1);
    if (is_face(word)) {
      while (end < letter.size() && letter[end] == ' ') ++end;
      at = behind_argument(letter, end);
      append_latex(plain, without_face(inside_braces(letter.substr(end, at - end))));
    } else {
      append_latex(plain, letter.substr(at, std::max(end, at + 2) - at));
      at = std::max(end, at + 2);
      while (at < letter.size() && letter[at] == ' ') ++at;
    }
  }
  return plain;
}

bool has_face(std::string_view letter) {
  for (std::size_t at = letter.find('\\'); at != std::string_view::npos; at = letter.find('\\', at + 1)) {
    if (is_face(letter.substr(at + 1, behind_word(letter, at) - at - 1))) return true;
  }
  return false;
}

void append_latex(std::string& a, std::string_view b) {
  const bool sign = !b.empty() && is_letter_or_digit(b.front());
  if (sign && ends_with_word(a)) a += ' ';
  a += b;
}

std::string subscript(const std::string& inside) {
  if (inside.empty()) return {};
  const bool one = inside.size() == 1 || (inside[0] == '\\' && behind_word(inside, 0) == inside.size());
  return one ? "_" + inside : "_{" + inside + "}";
}

}  // namespace rigor
