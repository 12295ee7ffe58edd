// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/subjects.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/prose_words.h"
#include "latex/token/words.h"

namespace rigor {

bool begins_with_a_case(std::string_view lead) {
  static constexpr auto openings = std::to_array<std::string_view>({"in", "for", "at", "on", "as", "near"});
  static constexpr auto neutral = std::to_array<std::string_view>(
      {"this", "that",    "the",  "these", "general",    "fact",   "particular", "all",
       "any",  "every",   "each", "terms", "components", "index",  "other",      "words",
       "both", "numbers", "our",  "its",   "which",      "before", "above"});
  const std::string text = lowered(lead);
  const std::vector<std::string_view> words = words_of(text);
  for (std::size_t k = 0; k + 1 < words.size() && k < 3; ++k) {
    if (!is_one_of(words[k], openings)) continue;
    if (!is_one_of(words[k + 1], neutral)) return true;
  }
  return false;
}

bool brings_in_a_subject(std::string_view lead) {
  static const WordSet plain(
      "hence thus so therefore consequently whence then finally now here and or it this that these they we "
      "one our its their which is to from by using with because since together being taking inserting "
      "substituting putting combining differentiating integrating solving eliminating dividing multiplying");
  const std::string clause = lowered(lead.substr(lead.rfind('\n') + 1));
  const std::vector<std::string_view> words = words_of(clause);
  if (words.empty()) return false;
  if (words.front() == "with") return words.size() < 2 || words[1] != "$";
  return !plain.contains(words.front());
}

bool speaks_of_any_order(const Prose& prose, std::size_t event, std::string_view heading) {
  static constexpr auto anywhere = std::to_array<std::string_view>(
      {"commute", "commuting", "diagonal", "scalar", "abelian", "simultaneous", "polynomial"});
  static constexpr auto near_by =
      std::to_array<std::string_view>({"axis", "numbers", "eigenvectors", "share", "together", "compatible",
                                       "acts on", "different", "multiple of", "independent", "factors"});
  const ProseBeside& here = prose.beside[event];
  const auto says = [](const std::string& text, const auto& words) {
    return text.find("not commut") == std::string::npos &&
           std::ranges::any_of(words,
                               [&](std::string_view each) { return text.find(each) != std::string::npos; });
  };
  return says(lowered(heading), anywhere) ||
         std::ranges::any_of(prose.sentences, [&](const ProseSentence& each) {
           if (!prose.sections.reaches(each.place, here.place)) return false;
           const std::string text = lowered(each.text);
           const bool near = each.number <= here.sentence && each.number + 4 > here.sentence;
           return says(text, anywhere) || (near && says(text, near_by));
         });
}

}  // namespace rigor
