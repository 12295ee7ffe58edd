// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/remarks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace rigor {
namespace {

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has_word(const std::string& text, std::string_view word) {
  const auto letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !letter(at - 1)) && !letter(at + word.size())) return true;
  }
  return false;
}

/// Words that name an equation, its parts or its source, and restrict nothing. A capital begins a name:
/// `Lagrange`.
bool names_only(const std::string& words) {
  static constexpr std::array harmless{
      "identity", "theorem",  "rule",     "law",      "definition", "by",     "using",  "from",
      "see",      "eq",       "eqs",      "equation", "proof",      "check",  "qed",    "the",
      "a",        "of",       "this",     "is",       "we",         "have",   "get",    "find",
      "recall",   "note",     "orbital",  "spin",     "kinetic",    "energy", "total",  "mass",
      "torque",   "momentum", "angular",  "inertia",  "tensor",     "moment", "scalar", "vector",
      "vectors",  "values",   "indices",  "numbers",  "and",        "dot",    "cross",  "triple",
      "product",  "expand",   "contract", "rename",   "rearrange"};
  std::string word;
  bool harmless_noun =
      false;  // a capital begins a name only beside a noun: `Lagrange's identity`, not `Orthogonal`
  bool any_name = false;
  const auto is_harmless = [&] {
    if (word.size() < 2) return true;
    if (std::isupper(static_cast<unsigned char>(word[0])) != 0) {
      any_name = true;
      return true;
    }
    const bool known = std::find(harmless.begin(), harmless.end(), word) != harmless.end();
    harmless_noun = harmless_noun || known;
    return known;
  };
  for (const char c : words + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += c;
      continue;
    }
    if (!is_harmless()) return false;
    word.clear();
  }
  return harmless_noun || !any_name;
}

}  // namespace

Remark remark_of(const std::string& words) {
  const std::string text = lowered(words);
  static constexpr std::array conditions{
      "if",         "when",    "where",         "whenever", "unless",       "provided", "only",      "no sum",
      "not summed", "with",    "since",         "given",    "assuming",     "limit",    "sum",       "summed",
      "let",        "suppose", "except",        "as",       "near",         "until",    "otherwise", "modulo",
      "mod",        "not",     "approximately", "cyclic",   "permutations", "etc"};
  static constexpr std::array<std::string_view, 4> quantifiers{"for all", "for any", "for every", "for each"};
  static constexpr std::array connectives{"and",    "or",      "so",        "thus",    "hence", "therefore",
                                          "i.e",    "that is", "also",      "while",   "but",   "so that",
                                          "giving", "gives",   "similarly", "likewise"};
  for (const std::string_view phrase : quantifiers) {
    const auto at = text.find(phrase);
    if (at == std::string::npos) continue;
    return names_only(words.substr(0, at) + words.substr(at + phrase.size())) ? Remark::quantifier
                                                                              : Remark::doubt;
  }
  for (const char* word : conditions) {
    if (has_word(text, word)) return Remark::condition;
  }
  if (has_word(text, "for") || has_word(text, "at") || has_word(text, "about")) return Remark::condition;
  for (const char* word : connectives) {
    if (has_word(text, word)) return Remark::connective;
  }
  return names_only(words) ? Remark::remark : Remark::doubt;
}

}  // namespace rigor
