// SPDX-License-Identifier: GPL-3.0-or-later
// What a definition is said for: a case, another place, or until its letter gets another meaning.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/special_definitions.h"
#include "check/prose/denial.h"
#include "check/prose/restrictions.h"
#include "check/walk/session.h"
#include "check/word/prose_words.h"

namespace rigor {

/// What its sentence says may make a case of the display at hand.
bool Session::is_conditional() const {
  const ProseBeside& beside = notes_.prose.beside[event_];
  return word_that_demands(beside.lead) || word_of_a_special_case(beside.lead + " " + beside.tail);
}

/// Its heading is about a special case: "Electrostatics", "In vacuum".
bool Session::is_of_a_case() const {
  static constexpr std::array<std::string_view, 6> cases{"statics",      "electrostatics", "magnetostatics",
                                                         "hydrostatics", "equilibrium",    "vacuum"};
  const std::string heading = lowered(section_);
  const std::vector<std::string_view> words = words_of(heading);
  return restriction_in_heading(heading) || word_of_a_special_heading(heading) ||
         std::any_of(words.begin(), words.end(),
                     [](std::string_view word) { return is_one_of(word, cases); });
}

/// A directive says what is meant here: `given I_{ij} = I_i\delta_{ij}`.
bool Session::is_assumed_about(SymbolId symbol) const {
  return std::any_of(
      names_.assumptions().begin(), names_.assumptions().end(), [&](const NamedAssumption& each) {
        if (!each.origin.directive) return false;
        const std::vector<SymbolId> letters = symbols_in(tree_, each.equation.left);
        return std::any_of(letters.begin(), letters.end(),
                           [&](SymbolId letter) { return base_of(tree_.symbols, letter) == symbol; });
      });
}

/// "In the medium $k = 2\pi n/\lambda$" below `k = 2\pi/\lambda`: the definitions of which a line of the
/// section has another one since.
std::vector<SymbolId> Session::said_anew() {
  const ProseBeside& beside = notes_.prose.beside[event_];
  std::vector<SymbolId> anew;
  for (const SaidInLine& said : notes_.prose.said) {
    const bool above = said.before <= event_ || said.sentence == beside.sentence;
    if (!above || said.cue == Cue::apart || !notes_.prose.sections.reaches(said.place, beside.place))
      continue;
    for (const ParsedChain& chain : said.chains) {
      if (chain.sides.size() != 2 || chain.written.relations[0].kind != RelationKind::equal ||
          notes_.syntax[chain.sides[0]].kind != SyntaxKind::symbol)
        continue;
      const auto reading = read_chain(notes_.syntax, tree_, names_, chain);
      const auto& left = reading->sides[0].typed;
      const auto& right = reading->sides[1].typed;
      if (!left || !right || tree_[left->id].op != Op::symbol || symbols_in(tree_, right->id).empty())
        continue;
      const NamedDefinition* named = names_.definition_of(tree_[left->id].symbol);
      if (named == nullptr || named->origin.directive || said.before <= named->origin.event) continue;
      if (is_assumed_about(named->definition.symbol)) continue;
      Diagnostics ignored;
      const auto claim = reading->claim(chain, 0, false, ignored);
      if (claim && judge(tree_, names_, *claim, {}, options_.cache).verdict != Verdict::proved)
        anew.push_back(named->definition.symbol);
    }
  }
  return anew;
}

/// A proof that rests on what is said for another case, or is said anew since, is taken back.
void Session::heed_proof(const ParsedChain& parsed, const Claim& claim, Judgement& judgement) {
  if (judgement.uses.empty()) return;
  Standpoint at = standpoint(parsed);
  at.denied = denial_of(notes_.prose, event_);
  at.said_anew = said_anew();
  judgement = heed_cases(tree_, names_, claim, std::move(judgement), at, options_.cache);
}

}  // namespace rigor
