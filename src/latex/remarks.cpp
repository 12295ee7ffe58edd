// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/remarks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

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

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

template <std::size_t N>
bool is_among(const std::string& word, const std::array<std::string_view, N>& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// "no sum", "no summation over repeated indices", "(not summed on j)".
bool says_no_sum(const std::vector<std::string>& words) {
  static constexpr std::array<std::string_view, 4> negations{"no", "not", "without", "never"};
  static constexpr std::array<std::string_view, 5> sums{"sum", "sums", "summed", "summation", "summing"};
  static constexpr std::array<std::string_view, 22> rest{
      "over",  "on", "in",   "for",     "the",      "index",      "indices", "repeated",
      "and",   "or", "here", "implied", "intended", "convention", "alpha",   "beta",
      "gamma", "mu", "nu",   "kappa",   "lambda",   "sigma"};
  std::size_t at = 0;
  if (words.size() > 1 && (words[0] == "with" || words[0] == "but" || words[0] == "and")) ++at;
  if (at + 1 >= words.size() || !is_among(words[at], negations)) return false;
  const bool implied = words[at + 1] == "implied" || words[at + 1] == "einstein";
  at += implied ? 2 : 1;
  if (at >= words.size() || !is_among(words[at], sums)) return false;
  return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end(),
                     [](const std::string& word) { return word.size() == 1 || is_among(word, rest); });
}

/// "and cyclic permutations of 1, 2, 3", "plus cyclic", "etc."; other letters than those of the axes are
/// another statement.
bool says_cyclic(const std::vector<std::string>& words) {
  static constexpr std::array<std::string_view, 5> cyclic{"cyclic", "cyclical", "cyclically", "cyc", "cycl"};
  static constexpr std::array<std::string_view, 20> rest{
      "permutations", "permutation", "permuted", "perm",       "perms",      "of",      "the",
      "indices",      "axes",        "labels",   "subscripts", "components", "thereof", "for",
      "other",        "others",      "1",        "2",          "3",          "rest"};
  if (words.size() == 1) return words[0] == "etc";
  if (words.size() < 2 || (words[0] != "and" && words[0] != "plus")) return false;
  if (words.size() == 2 && words[1] == "etc") return true;
  return is_among(words[1], cyclic) &&
         std::all_of(words.begin() + 2, words.end(), [](const std::string& word) {
           return is_among(word, rest) || word == "x" || word == "y" || word == "z";
         });
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
  const std::vector<std::string> spoken = words_of(text);
  if (says_no_sum(spoken)) return Remark::no_sum;
  if (says_cyclic(spoken)) return Remark::cyclic;
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
