// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/row/given_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/approximate_value.h"
#include "check/meaning/measured.h"
#include "check/question/granted.h"
#include "check/row/row.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

bool gives(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::nearly || kind == RelationKind::defines;
}

/// "If the temperature were $T = 600\,\mathrm K$, …" gives no value to other sentences.
bool is_supposed(const RowPlace& place, const SaidInLine& said) {
  const std::vector<ProseSentence>& sentences = place.notes.prose.sentences;
  const auto sentence = std::ranges::find(sentences, said.sentence, &ProseSentence::number);
  return sentence != sentences.end() && word_that_demands(lowered(sentence->text)).has_value();
}

void note_values_in_lines(RowPlace& place, std::vector<GivenValue>& values) {
  std::vector<GivenValue> said = said_of_letters(place);
  std::erase_if(said, [&](const GivenValue& each) { return !is_measured(place.tree, each.number); });
  values.insert(values.end(), said.begin(), said.end());
}

void note_values_in_displays(const RowPlace& place, std::vector<GivenValue>& values) {
  for (const StatedLaw& stated : place.above.stated) {
    const PageLaw& law = stated.law;
    if (!place.notes.prose.sections.reaches(law.place, beside(place).place)) continue;
    const auto letter = bare_letter(place.tree, law.equation.left);
    if (letter && is_measured(place.tree, law.equation.right))
      values.push_back({*letter, law.equation.right, law.name});
  }
}

}  // namespace

std::optional<SymbolId> bare_letter(const ExprTree& tree, ExprId side) {
  const ExprNode& node = tree[side];
  const bool bare = node.op == Op::symbol && node.rank == 0 && node.slot_count == 0 &&
                    node.particle == no_particle && !tree.symbols[node.symbol].derivation &&
                    !tree.symbols[node.symbol].is_fixed();
  return bare ? std::optional(node.symbol) : std::nullopt;
}

std::vector<GivenValue> values_above(RowPlace& place) {
  std::vector<GivenValue> all;
  note_values_in_displays(place, all);
  note_values_in_lines(place, all);
  std::vector<GivenValue> last;
  for (auto value = all.rbegin(); value != all.rend(); ++value) {
    const auto is_other = [&](const GivenValue& other) {
      return &other != &*value && other.letter == value->letter && other.sentence == value->sentence &&
             dump(place.tree, other.number) != dump(place.tree, value->number);
    };
    const auto is_same = [&](const GivenValue& other) { return other.letter == value->letter; };
    const auto is_another = [&](const GivenValue& other) {
      return is_same(other) && dump(place.tree, other.number) != dump(place.tree, value->number);
    };
    if (std::ranges::any_of(last, is_same)) continue;
    if (value->sentence > 0 && std::ranges::any_of(all, is_other)) continue;
    if (value->sentence != beside(place).sentence && std::ranges::any_of(all, is_another)) continue;
    last.push_back(*value);
  }
  return last;
}

std::vector<GivenValue> said_of_letters(RowPlace& place, bool divides_by_all) {
  std::vector<GivenValue> all;
  const ProseBeside& here = beside(place);
  for (const SaidInLine& said : place.notes.prose.said) {
    const bool above =
        said.before <= place.event && place.notes.prose.sections.reaches(said.place, here.place);
    const bool own = said.sentence == here.sentence;
    if (said.cue == Cue::apart || (!above && !own) || (!own && is_supposed(place, said))) continue;
    for (const ParsedChain& chain : said.chains) {
      if (chain.sides.size() != 2 || !gives(chain.written.relations[0].kind)) continue;
      const auto reading =
          read_chain(place.notes.syntax, place.tree, place.names, chain, {.divides_by_all = divides_by_all});
      add_used(place, reading->used());
      const auto& left = reading->sides[0].typed;
      const auto& right = reading->sides[1].typed;
      const auto letter = left && right ? bare_letter(place.tree, left->id) : std::nullopt;
      if (!letter) continue;
      all.push_back({*letter, right->id,
                     fmt::format("{} (line {})", written_at(place, said.span),
                                 place.sources.line_column(said.span.file, said.span.begin).line),
                     said.sentence});
    }
  }
  return all;
}

Names with_values(const RowPlace& place, const ParsedChain& parsed, const Claim& claim,
                  const std::vector<GivenValue>& values, bool again, bool laws) {
  Names names = place.names;
  const auto own = bare_letter(place.tree, claim.equation.left);
  for (const GivenValue& value : values) {
    if (own == value.letter || (!again && definition_of(names.scope, value.letter) != nullptr)) continue;
    forget_definition(names.scope, value.letter);
    define(names.scope,
           {{value.letter, {}, no_particle, value.number}, Origin{value.text, {}, std::nullopt}, 0});
  }
  // That the digits agree shows that it is the same thing.
  const Laws above = laws ? available_to(place, parsed, true) : Laws{};
  for (auto law = above.rbegin(); law != above.rend(); ++law) {
    const auto letter = bare_letter(place.tree, (*law)->equation.left);
    if (!letter || (*law)->standing == Standing::conclusion ||
        is_measured(place.tree, (*law)->equation.right))
      continue;
    const bool defined = definition_of(names.scope, *letter) != nullptr;
    if (defined && (!again || approximate_value(place.tree, names, (*law)->equation.left))) continue;
    forget_definition(names.scope, *letter);
    take_for_granted(place.tree, names, (*law)->equation,
                     Origin{(*law)->name, {}, std::nullopt, {}, (*law)->place}, false);
  }
  return names;
}

std::vector<std::string> uses_of(const ExprTree& tree, const Names& names, const Claim& claim) {
  std::vector<std::string> uses;
  for (const SymbolId letter :
       symbols_reached(tree, names.scope, {claim.equation.left, claim.equation.right})) {
    const NamedDefinition* named = definition_of(names.scope, letter);
    if (named != nullptr && !is_one_of(named->origin.text, uses)) uses.push_back(named->origin.text);
  }
  return uses;
}

void prove_by_numbers(RowPlace& place, const StepReading& row, const Claim& claim,
                      std::vector<std::string> uses, std::string route, Judgement& judgement) {
  judgement.verdict = Verdict::proved;
  judgement.route = std::move(route);
  judgement.measures = true;
  judgement.of_another_question = true;
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.diagnostics.clear();
  judgement.uses = std::move(uses);
  leave_to_rows_below(place, row.parsed, claim.equation, claim.relation, Standing::result);
}

bool number_may_be_suspected(const RowPlace& place, const StepReading& row, const Claim& claim,
                             bool spelled_out) {
  const std::string& lead = beside(place).lead;
  const std::string clause = lowered(lead.substr(lead.rfind('\n') + 1));
  const bool in_numbers =
      clause.find("in numbers") != std::string::npos || clause.find("numerical") != std::string::npos;
  const bool goes_on =
      row.which > 0 || spelled_out || in_numbers || says_that_it_follows(lead) || !has_own_words(clause);
  if (!goes_on || place.is_stated || may_be_of_a_case(place, row.parsed) || is_alternative(place, row.parsed))
    return false;
  const auto own = bare_letter(place.tree, claim.equation.left);
  return std::ranges::none_of(place.above.stated, [&](const StatedLaw& stated) {
    return own && bare_letter(place.tree, stated.law.equation.left) == own &&
           is_measured(place.tree, stated.law.equation.right);
  });
}

bool is_far(double ratio, int digits) {
  return std::abs(ratio - 1) > std::max(0.03, 10 * std::pow(10.0, 1 - digits));
}

}  // namespace rigor
