// SPDX-License-Identifier: GPL-3.0-or-later
// What a definition is said for: a case, another place, or until its letter gets another meaning.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/special_definitions.h"
#include "check/meaning/measured.h"
#include "check/place/place.h"
#include "check/prose/denial.h"
#include "check/prose/restrictions.h"
#include "check/word/prose_words.h"

namespace rigor {

namespace {

/// A directive says what is meant here: `given I_{ij} = I_i\delta_{ij}`.
bool is_assumed_about(const RowPlace& place, SymbolId symbol) {
  return std::ranges::any_of(place.names.scope.assumptions, [&](const NamedAssumption& each) {
    if (!each.origin.directive) return false;
    return std::ranges::any_of(symbols_in(place.tree, each.equation.left), [&](SymbolId letter) {
      return base_of(place.tree.symbols, letter) == symbol;
    });
  });
}

/// "In the medium $k = 2\pi n/\lambda$" below `k = 2\pi/\lambda`: the definitions that a line of the section
/// has replaced since.
std::vector<SymbolId> said_anew(RowPlace& place) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  std::vector<SymbolId> anew;
  for (const SaidInLine& said : place.notes.prose.said) {
    const bool above = said.before <= place.event || said.sentence == beside.sentence;
    if (!above || said.cue == Cue::apart || !place.notes.prose.sections.reaches(said.place, beside.place))
      continue;
    for (const ParsedChain& chain : said.chains) {
      if (chain.sides.size() != 2 || chain.written.relations[0].kind != RelationKind::equal ||
          place.notes.syntax[chain.sides[0]].kind != SyntaxKind::symbol)
        continue;
      const auto reading = read_here(place, chain);
      const auto& left = reading->sides[0].typed;
      const auto& right = reading->sides[1].typed;
      if (!left || !right || place.tree[left->id].op != Op::symbol || is_measured(place.tree, right->id))
        continue;
      const NamedDefinition* named = definition_of(place.names.scope, place.tree[left->id].symbol);
      if (named == nullptr || named->origin.directive || said.before <= named->origin.event) continue;
      if (is_assumed_about(place, named->definition.symbol)) continue;
      Diagnostics ignored;
      const auto claim = reading->claim(chain, 0, false, ignored);
      if (claim && judge_here(place, *claim).verdict != Verdict::proved)
        anew.push_back(named->definition.symbol);
    }
  }
  return anew;
}

/// "because of (2) \n where": what is explained behind an earlier display of the sentence is not of the case
/// that the words before that display name.
std::string_view clause_of(std::string_view lead) {
  const auto display = lead.rfind('\n');
  if (display == std::string_view::npos) return lead;
  const std::string_view clause = lead.substr(display + 1);
  const std::vector<std::string_view> words = words_of(clause);
  return !words.empty() && words[0] == "where" ? clause : lead;
}

/// "For a constant $k$" says what the letter is, and "for a reversible change" what a differential is: both
/// name no case.
std::string without_neutral_phrases(std::string text) {
  for (const std::string_view said : {"for a constant $", "for constant $", "constants $", "constant $"}) {
    for (auto at = text.find(said); at != std::string::npos; at = text.find(said))
      text.replace(at, said.size() - 1, "");
  }
  for (const std::string_view said :
       {"for a reversible change", "for a reversible process", "in a reversible change",
        "in a reversible process", "for an infinitesimal change", "for a quasistatic change",
        "for a quasistatic process", "for reversible changes", "for reversible processes"}) {
    for (auto at = text.find(said); at != std::string::npos; at = text.find(said))
      text.replace(at, said.size(), "");
  }
  return text;
}

/// "orbit" of "orbits"
std::string_view singular(std::string_view word) {
  return word.size() > 3 && word.ends_with('s') ? word.substr(0, word.size() - 1) : word;
}

/// "For a circular orbit" below the heading "Circular orbits" names no case: the whole section is about it.
std::string without_what_heading_says(std::string text, std::string_view heading) {
  static constexpr std::array<std::string_view, 6> articles{"a", "an", "the", "any", "every", "such"};
  std::vector<std::string_view> headed = words_of(heading);
  if (is_one_of("and", headed) || is_one_of("or", headed) || is_one_of("versus", headed)) return text;
  std::ranges::transform(headed, headed.begin(), singular);
  static constexpr std::string_view beginning = "for ";
  for (auto at = text.find(beginning); at != std::string::npos; at = text.find(beginning, at + 1)) {
    if (at > 0 && is_letter(text[at - 1])) continue;
    const auto end = std::min(text.find_first_of(",;:.$\n", at), text.size());
    const std::string phrase = text.substr(at + beginning.size(), end - at - beginning.size());
    std::vector<std::string_view> words = words_of(phrase);
    std::erase_if(words, [](std::string_view word) { return is_one_of(word, articles); });
    const bool said =
        std::ranges::all_of(words, [&](std::string_view word) { return is_one_of(singular(word), headed); });
    if (said && !words.empty()) text.erase(at, end - at);
  }
  return text;
}

/// "Let $ be the distance", "let $ and $ denote their masses": what letters are called, so that nothing is
/// supposed. The words from there on; all words where it says something else, such as "let $ be constant".
std::string_view without_naming(std::string_view lead) {
  static constexpr std::string_view let = "let $";
  const auto begin = lead.find(let);
  if (begin == std::string_view::npos) return lead;
  const std::string_view rest = lead.substr(begin + let.size());
  const std::vector<std::string_view> words = words_of(rest);
  std::size_t at = 0;
  while (at < words.size() && is_one_of(words[at], {"$", "and"})) ++at;
  if (at + 2 >= words.size()) return lead;
  const bool is_called = is_one_of(words[at], {"denote", "denotes", "represent", "represents"});
  const bool is_the = words[at] == "be" && is_one_of(words[at + 1], {"the", "its", "their", "our"}) &&
                      words[at + 2] != "same";
  return is_called || is_the ? rest : lead;
}

/// "which does not change, because": the reason limits nothing to a case.
std::size_t begin_of_reason(const std::string& tail) {
  std::size_t begin = tail.size();
  for (const std::string_view word : {"because", "since"}) begin = std::min(begin, tail.find(word));
  return begin;
}

/// Before a display, in its clause, and behind it, up to a reason.
struct WordsAround {
  std::string lead;
  std::string behind;
};

WordsAround words_around(const RowPlace& place) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  return {std::string(clause_of(beside.lead)), beside.tail.substr(0, begin_of_reason(beside.tail))};
}

/// "For small oscillations": who leaves out what is small goes on so.
std::string without_smallness(std::string text) {
  for (const std::string_view noun :
       {"angles", "oscillations", "amplitudes", "displacements", "deviations", "vibrations", "elongations"}) {
    const std::string said = fmt::format("for small {}", noun);
    for (auto at = text.find(said); at != std::string::npos; at = text.find(said))
      text.erase(at, said.size());
  }
  return text;
}

bool is_conditional_by(const WordsAround& words, const RowPlace& place, bool demands) {
  return (demands && word_that_demands(without_naming(words.lead))) ||
         word_of_a_special_case(without_neutral_phrases(
             without_what_heading_says(words.lead + " " + words.behind, lowered(place.section))));
}

}  // namespace

bool is_conditional(const RowPlace& place, bool demands) {
  return is_conditional_by(words_around(place), place, demands);
}

bool is_of_a_passing_case(const RowPlace& place, bool demands) {
  WordsAround words = words_around(place);
  for (std::string* text : {&words.lead, &words.behind}) *text = without_smallness(*text);
  return is_conditional_by(words, place, demands);
}

bool is_of_a_case(const RowPlace& place) {
  static constexpr std::array<std::string_view, 6> cases{"statics",      "electrostatics", "magnetostatics",
                                                         "hydrostatics", "equilibrium",    "vacuum"};
  const std::string heading = lowered(place.section);
  return restriction_in_heading(heading) || word_of_a_special_heading(heading) ||
         std::ranges::any_of(words_of(heading), [](std::string_view word) { return is_one_of(word, cases); });
}

bool is_one_of_the_cases(const RowPlace& place, const ParsedChain& parsed) {
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || !parsed.written.premise) return false;
  return std::ranges::any_of(display->chains, [&](const ParsedChain& chain) {
    return chain.written.premise && chain.written.statement != parsed.written.statement;
  });
}

Standpoint standpoint_of_proofs(RowPlace& place, const ParsedChain& parsed) {
  Standpoint at = standpoint(place, parsed);
  at.denied = denial_of(place.notes.prose, place.event);
  at.said_anew = said_anew(place);
  return at;
}

void heed_proof(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement) {
  if (auto doubt = about_turning_axes(place, claim)) return withdraw(judgement, claim, *std::move(doubt));
  if (judgement.uses.empty()) return;
  const Standpoint at = standpoint_of_proofs(place, parsed);
  judgement = heed_cases(place.tree, place.names, claim, std::move(judgement), at, place.options.cache);
  add_used(place, judgement.used);
}

}  // namespace rigor
