// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/place_words.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/among.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

using Words = std::vector<std::string_view>;

std::string_view word_or_none(const Words& words, std::size_t at) {
  return at < words.size() ? words[at] : std::string_view{};
}

bool is_article(std::string_view word) {
  return is_one_of(word, {"the", "a", "an", "its", "their", "this", "that", "each", "both", "either", "one",
                          "two", "inner", "outer", "upper", "lower", "left", "right"});
}

/// "Acts on", "the force on", "depends on", "from then on": no place.
bool takes_on(std::string_view word) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"act",    "acts",   "acting", "force",   "forces", "torque",   "depend",  "depends",  "depending",
       "based",  "work",   "done",   "exerted", "exerts", "exert",    "effect",  "rely",     "relies",
       "focus",  "goes",   "go",     "later",   "now",    "then",     "so",      "early",    "carry",
       "rests",  "relied", "onward", "moves",   "impose", "imposed",  "operate", "operates", "operating",
       "insist", "going",  "pull",   "push",    "sum",    "pressure", "load",    "comment",  "condition"});
  return is_one_of(word, words);
}

/// "On the other hand", "on average", "on the body"
bool is_no_place(std::string_view word) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"hand",        "average",      "account",     "top",       "dividing",
       "multiplying", "taking",       "squaring",    "paper",     "page",
       "other",       "mass",         "charge",      "planet",    "ball",
       "object",      "electron",     "satellite",   "block",     "condition",
       "using",       "substituting", "integrating", "inserting", "differentiating",
       "expanding",   "physical",     "grounds",     "purpose"});
  return is_one_of(word, words) || is_general_noun(word) || word.ends_with("ing");
}

bool is_spot(std::string_view word) {
  return is_one_of(word, {"middle", "centre", "center", "corner", "midpoint", "origin", "vertex", "apex"});
}

}  // namespace

bool names_a_spot(std::string_view lead) {
  const Words words = words_of(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "on" && (k == 0 || !takes_on(words[k - 1]))) {
      std::size_t noun = k + 1;
      while (is_article(word_or_none(words, noun))) ++noun;
      const std::string_view word = word_or_none(words, noun);
      if (!word.empty() && word != "$" && !is_no_place(word)) return true;
    }
    const bool line = words[k] == "along" && is_article(word_or_none(words, k + 1)) &&
                      is_one_of(word_or_none(words, k + 2), {"edge", "rim", "wall", "boundary", "contour"});
    if (line) return true;
    const bool in = is_one_of(words[k], {"in", "near"});
    if (in && is_article(word_or_none(words, k + 1)) && is_spot(word_or_none(words, k + 2))) return true;
    if (is_one_of(words[k], {"touches", "touching"})) return true;
  }
  return false;
}

bool asks_directly(std::string_view lead) {
  const Words words = words_of(lead);
  if (words.empty()) return false;
  if (is_one_of(words.back(), {"if", "when", "whenever", "unless", "provided", "once", "until", "iff"}))
    return true;
  return words.back() == "that" && words.size() > 1 &&
         is_one_of(words[words.size() - 2], {"provided", "moment"});
}

}  // namespace rigor
