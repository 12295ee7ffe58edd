// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/other_case.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/contrary_words.h"

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
    : in_heading_(case_words_of(lowered(heading))), heading_(heading) {
  const ProseBeside& beside = prose.beside[event];
  for (const ProseSentence& each : prose.sentences) {
    if (each.number >= beside.sentence) break;
    if (!prose.sections.reaches(each.place, beside.place)) continue;
    for (std::string& word : case_words_of(each.text)) named_.push_back({std::move(word), each.number});
  }
  for (std::string& word : case_words_of(last_clause(beside.lead)))
    named_.push_back({std::move(word), beside.sentence + 1});
}

bool CasesNamed::names_another_since(const CaseSaid& said, bool defines) const {
  const auto shuts_out = [&](const std::string& word, const std::string& here) {
    return defines ? is_kind_shut_out_by(word, here) : is_shut_out_by(word, here);
  };
  const auto is_another = [&](const std::string& here) {
    return !is_one_of(here, said.words) &&
           std::ranges::any_of(said.words, [&](const std::string& word) { return shuts_out(word, here); });
  };
  std::optional<std::string> other;
  if (heading_ != said.heading) {
    const auto found = std::ranges::find_if(in_heading_, is_another);
    if (found != in_heading_.end()) other = *found;
  }
  for (const Named& each : named_) {
    if (each.sentence <= said.sentence) continue;
    if (is_another(each.word)) {
      other = each.word;
    } else if (other && is_one_of(each.word, said.words) && shuts_out(each.word, *other)) {
      other.reset();  // back to the first one
    }
  }
  return other.has_value();
}

}  // namespace rigor
