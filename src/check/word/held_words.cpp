// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/held_words.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

constexpr std::size_t most_words_between = 2;  // "keeping the total energy fixed"

/// Adjectives of processes, and what is held in them.
constexpr auto processes =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"isothermal", "temperature"},
                                                                  {"isothermally", "temperature"},
                                                                  {"isotherm", "temperature"},
                                                                  {"isobaric", "pressure"},
                                                                  {"isobar", "pressure"},
                                                                  {"isochoric", "volume"}});

bool is_still(std::string_view word) { return is_one_of(word, {"constant", "fixed"}); }

bool is_holding(std::string_view word) {
  return is_one_of(word, {"keep", "keeps", "keeping", "kept", "hold", "holds", "holding", "held", "with",
                          "while", "where", "if"});
}

bool links_to_still(std::string_view word) {
  return is_one_of(word, {"is", "are", "held", "kept", "being", "stays", "remains", "at"});
}

/// "is not constant", "instead of an isothermal one", "suppose that $T$ is constant".
bool takes_back(std::string_view word) {
  return is_one_of(word, {"not",     "no",       "never",   "non",     "instead", "unlike",        "rather",
                          "than",    "contrary", "without", "suppose", "if",      "would",         "were",
                          "neither", "nor",      "nearly",  "almost",  "roughly", "approximately", "or",
                          "from",    "longer",   "compare", "compared"});
}

/// Words that say of what kind a quantity is: "the absolute temperature".
bool says_of_a_noun(std::string_view word) {
  return is_one_of(word, {"the", "a", "an", "its", "their", "is", "are", "be", "denotes", "absolute", "total",
                          "common", "given"});
}

}  // namespace

HeldByWords held_by_words(std::string_view text) {
  const std::string lower = lowered(std::string(text));
  const std::vector<std::string_view> words = words_of(lower);
  HeldByWords held;
  if (std::ranges::any_of(words, takes_back)) return held;
  std::vector<std::size_t> maths(words.size(), 0);  // how many stand before each word
  for (std::size_t k = 1; k < words.size(); ++k) maths[k] = maths[k - 1] + (words[k - 1] == "$" ? 1 : 0);
  const auto take = [&](std::size_t at) {
    if (at >= words.size()) return;
    if (words[at] == "$") {
      held.maths.insert(maths[at]);
    } else if (words[at].size() > 3 && !says_of_a_noun(words[at])) {
      held.nouns.insert(std::string(words[at]));
    }
  };
  for (std::size_t k = 0; k < words.size(); ++k) {
    for (const auto& [adjective, noun] : processes) {
      if (words[k] == adjective) held.nouns.insert(std::string(noun));
    }
    if (!is_still(words[k])) continue;
    // "at constant temperature", "for fixed $T$", "keeping $T$ constant", "the temperature is constant"
    const bool before = k > 0 && is_one_of(words[k - 1], {"at", "for", "of", "under", "with", "and"});
    if (before) {
      take(k + 1);
      continue;
    }
    std::size_t at = k;
    for (std::size_t n = 0; n < most_words_between && at > 0 && links_to_still(words[at - 1]); ++n) --at;
    const bool linked = at < k;
    const std::size_t begin = at - std::min(at, most_words_between + 2);
    const bool kept = std::any_of(words.begin() + static_cast<std::ptrdiff_t>(begin),
                                  words.begin() + static_cast<std::ptrdiff_t>(at), is_holding);
    if (at > 0 && (linked || kept)) take(at - 1);
  }
  return held;
}

std::optional<std::size_t> maths_called(std::string_view sentence, std::string_view noun) {
  const std::string lower = lowered(std::string(sentence));
  const std::vector<std::string_view> words = words_of(lower);
  std::size_t maths = 0;  // before the word at hand
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "$") {
      ++maths;
      continue;
    }
    if (words[k] != noun) continue;
    const std::size_t next = k + 1 < words.size() && words[k + 1] == "is" ? k + 2 : k + 1;
    if (next < words.size() && words[next] == "$") return maths;
    std::size_t at = k;
    while (at > 0 && says_of_a_noun(words[at - 1])) --at;
    if (at > 0 && at < k && words[at - 1] == "$") return maths - 1;
  }
  return std::nullopt;
}

}  // namespace rigor
