// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/denial.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/among.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

using Words = std::vector<std::string_view>;

/// "which is wrong", "but this cannot hold", "This fails", "No": not "it is false that", which points ahead.
bool points_back(std::string_view text) {
  static constexpr std::array<std::string_view, 16> pointing{
      "this", "that",  "which", "it",   "no",        "wrong", "cannot",     "is",
      "does", "these", "both",  "such", "incorrect", "false", "correction", "fails"};
  static constexpr std::array<std::string_view, 7> relations{"formula", "equation", "expression", "relation",
                                                             "result",  "sign",     "step"};
  static constexpr std::array<std::string_view, 4> joining{"but", "and", "however", "yet"};
  const Words words = words_of(text);
  std::size_t at = 0;
  while (at < words.size() && is_one_of(words[at], joining)) ++at;
  if (at == words.size() || words.back() == "that") return false;
  const bool relation = words[at] == "the" && at + 1 < words.size() && is_one_of(words[at + 1], relations);
  return relation || is_one_of(words[at], pointing);
}

/// Not "It is tempting to think …", "But beware".
std::optional<std::string> word_that_denies_it(std::string_view text) {
  static constexpr std::array<std::string_view, 4> warning{"tempting", "beware", "believe", "believes"};
  auto word = word_that_denies(text);
  return word && is_one_of(*word, warning) ? std::nullopt : word;
}

/// "This fails, so instead we have": what follows is what holds.
bool turns_around(std::string_view text) {
  static constexpr std::array<std::string_view, 18> turning{
      "so",     "instead", "rather", "correct", "right",  "true",   "therefore", "hence",     "actually",
      "indeed", "must",    "should", "but",     "really", "proper", "correctly", "corrected", "thus"};
  const Words words = words_of(text);
  for (std::size_t k = words.size(); k-- > 0;) {
    if (is_one_of(words[k], turning)) return true;
    if (word_that_denies(words[k])) return false;
  }
  return false;
}

/// The clause that leads into a display, after another one in its sentence.
std::string_view clause_of(std::string_view lead) {
  const auto display = lead.rfind('\n');
  return display == std::string_view::npos ? lead : lead.substr(display + 1);
}

}  // namespace

std::optional<std::string> denial_of(const Prose& prose, std::size_t event) {
  const ProseBeside& beside = prose.beside[event];
  const std::string_view lead = clause_of(beside.lead);
  const bool about_another = beside.lead.find('\n') != std::string::npos && points_back(lead);
  if (!about_another && !turns_around(lead)) {
    // "the load at which it fails is" speaks of what fails
    if (auto word = word_that_denies(lead); word && !word->starts_with("fail")) return word;
  }
  if (!words_of(beside.tail).empty()) {
    const bool leads_on = std::any_of(
        prose.beside.begin() + static_cast<std::ptrdiff_t>(event), prose.beside.end(), [&](const auto& each) {
          return each.sentence == beside.sentence && each.displays > beside.displays;
        });
    return leads_on && !points_back(beside.tail) ? std::nullopt : word_that_denies_it(beside.tail);
  }
  for (const ProseSentence& next : prose.sentences) {
    if (next.number <= beside.sentence) continue;
    if (next.displays != beside.displays || !prose.sections.reaches(next.place, beside.place)) break;
    const std::string_view text = std::string_view(next.text).substr(0, next.text.find('\n'));
    if (text == "no" || text == "wrong") return std::string(text);
    return points_back(text) ? word_that_denies_it(text) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace rigor
