// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/other_case.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/contrary_words.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// Not those of another case than that of the words before.
void add_words(std::vector<std::string>& words, const std::string& text) {
  std::vector<std::string> more = case_words_of(text);
  std::erase_if(more, [&](const std::string& word) {
    return is_one_of(word, words) || std::ranges::any_of(words, [&](const std::string& known) {
             return is_shut_out_by(known, word) || is_shut_out_by(word, known);
           });
  });
  std::ranges::move(more, std::back_inserter(words));
}

/// Sentences have increasing numbers; some numbers have none.
auto sentence_at(const Prose& prose, std::size_t number) {
  return std::ranges::lower_bound(prose.sentences, number, {}, &ProseSentence::number);
}

/// The words since the last display.
std::string last_clause(const std::string& lead) {
  const auto display = lead.rfind('\n');
  return display == std::string::npos ? lead : lead.substr(display + 1);
}

}  // namespace

bool names_an_opposite_since(const Prose& prose, std::size_t event, std::size_t sentence) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"opposite", "oppositely", "reverse", "reverses", "reversed", "backward", "backwards", "down",
       "downward", "downwards", "contrary", "antiparallel", "clockwise", "counterclockwise", "leftward",
       "leftwards", "inward", "inwards", "repulsive"});
  const auto says = [](std::string_view text) {
    const std::string small = lowered(text);
    return std::ranges::any_of(words_of(small), [](std::string_view word) { return is_one_of(word, words); });
  };
  const ProseBeside& here = prose.beside[event];
  if (says(last_clause(here.lead)) || says(here.tail)) return true;
  for (auto each = sentence_at(prose, sentence + 1);
       each != prose.sentences.end() && each->number < here.sentence; ++each) {
    if (each->place == here.place && says(each->text)) return true;
  }
  return false;
}

CaseSaid case_said_in(const Prose& prose, std::size_t sentence, const std::string& heading) {
  CaseSaid said{.sentence = sentence, .heading = heading};
  auto at = sentence_at(prose, sentence);
  if (at != prose.sentences.end() && at->number == sentence) {
    const std::size_t paragraph = at->paragraph;
    add_words(said.words, at->text);
    for (; at != prose.sentences.begin() && std::prev(at)->paragraph == paragraph; --at)
      add_words(said.words, std::prev(at)->text);
  }
  add_words(said.words, lowered(heading));
  return said;
}

CaseSaid case_said_at(const Prose& prose, std::size_t event, const std::string& heading) {
  return case_said_in(prose, prose.beside[event].sentence, heading);
}

CasesNamed::CasesNamed(const Prose& prose, std::size_t event, const std::string& heading)
    : different_(prose.case_words.different),
      sentence_(prose.beside[event].sentence),
      last_clause_(case_words_of(last_clause(prose.beside[event].lead))),
      in_heading_(case_words_of(lowered(heading))),
      heading_(heading) {
  std::size_t place = prose.beside[event].place;
  bool reaches = true;
  for (const CaseWord& each : prose.case_words.said) {
    if (each.sentence >= sentence_) break;
    if (each.place != place) {
      place = each.place;
      reaches = prose.sections.reaches(place, prose.beside[event].place);
    }
    if (reaches) named_.push_back(each);
  }
}

/// Many words are said, few differ, and words are dear to compare: each is compared once.
bool CasesNamed::names_another_since(const CaseSaid& said, bool defines) const {
  if (said.words.empty()) return false;
  const auto shuts_out = [&](const std::string& word, const std::string& here) {
    return defines ? is_kind_shut_out_by(word, here) : is_shut_out_by(word, here);
  };
  enum class Stand : std::uint8_t { unknown, nothing, own, another };
  const auto stand_of = [&](const std::string& here) {
    if (is_one_of(here, said.words)) return Stand::own;
    const bool another =
        std::ranges::any_of(said.words, [&](const std::string& word) { return shuts_out(word, here); });
    return another ? Stand::another : Stand::nothing;
  };
  const std::string* other = nullptr;
  if (heading_ != said.heading) {
    const auto found = std::ranges::find(in_heading_, Stand::another, stand_of);
    if (found != in_heading_.end()) other = &*found;
  }
  const auto hear = [&](const std::string& word, Stand stand) {
    if (stand == Stand::another) {
      other = &word;
    } else if (other != nullptr && stand == Stand::own && shuts_out(word, *other)) {
      other = nullptr;  // back to the first one
    }
  };
  std::vector<Stand> stands(different_.size(), Stand::unknown);
  for (auto at = std::ranges::upper_bound(named_, said.sentence, {}, &CaseWord::sentence); at != named_.end();
       ++at) {
    Stand& stand = stands[at->word];
    if (stand == Stand::unknown) stand = stand_of(different_[at->word]);
    hear(different_[at->word], stand);
  }
  // The last clause before the row stands behind what its own sentence says.
  if (sentence_ >= said.sentence) {
    for (const std::string& word : last_clause_) hear(word, stand_of(word));
  }
  return other != nullptr;
}

}  // namespace rigor
