// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/problem_words.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// "The trial solution works if", "if we try": which one works is found there.
bool asks_when_a_trial_works(std::span<const std::string_view> words, std::size_t at) {
  if (words[at] != "if") return false;
  if (at + 1 < words.size() && words[at + 1] == "we") return true;
  return at > 0 && is_one_of(words[at - 1], {"works", "solves", "it", "solution", "equation", "only"});
}

}  // namespace

bool speaks_of_a_trial(const std::string& sentence) {
  const std::string text = lowered(sentence);
  static constexpr std::array<std::string_view, 8> stems{"ansatz",    "trial", "try",   "insert",
                                                         "substitut", "plug",  "guess", "seek"};
  static constexpr std::array<std::string_view, 4> phrases{"of the form", "look for", "plane wave",
                                                           "standing wave"};
  if (std::ranges::any_of(phrases,
                          [&](std::string_view phrase) { return text.find(phrase) != std::string::npos; }))
    return true;
  return std::ranges::any_of(words_of(text), [](std::string_view word) {
    return std::ranges::any_of(stems, [&](std::string_view stem) { return word.starts_with(stem); });
  });
}

bool turns_a_problem_down(const std::string& sentence, bool tries) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"wrong",   "wrongly",   "false",    "incorrect", "incorrectly", "mistaken", "mistake",
       "not",     "no",        "never",    "cannot",    "nor",         "neither",  "without",
       "unlike",  "compare",   "compared", "instead",   "rather",      "contrary", "contrast",
       "whereas", "different", "differs",  "other",     "another",     "replaced", "except",
       "unless",  "forget",    "suppose",  "imagine",   "would",       "were",     "if"});
  const std::string text = lowered(sentence);
  const std::vector<std::string_view> said = words_of(text);
  for (std::size_t k = 0; k < said.size(); ++k) {
    // "With $y(0) = 1$ and two different roots"
    const bool counts =
        said[k] == "different" && k > 0 && is_one_of(said[k - 1], {"two", "three", "both", "several", "all"});
    if (is_one_of(said[k], words) && !counts && !(tries && asks_when_a_trial_works(said, k))) return true;
  }
  return false;
}

bool points_at_the_row_above(std::string_view lead) {
  static constexpr std::array<std::string_view, 5> stems{"insert", "substitut", "plug", "put", "introduc"};
  const std::string text = lowered(lead);
  const std::vector<std::string_view> words = words_of(text);
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    const bool inserts =
        std::ranges::any_of(stems, [&](std::string_view stem) { return words[k].starts_with(stem); });
    if (inserts && is_one_of(words[k + 1], {"this", "it", "these", "that"})) return true;
  }
  return false;
}

}  // namespace rigor
