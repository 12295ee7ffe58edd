// SPDX-License-Identifier: GPL-3.0-or-later
// What the words and the relations around a row leave of its proof.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/place/place.h"
#include "check/prose/turning_axes.h"
#include "check/question/base_letters.h"
#include "check/repair/repair.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// `x` of "for all $x$", "for every real number $x$", "for all $x, y$" in the sentence of the row, where x is
/// one of the letters.
std::optional<std::string> letter_said_for_all(const RowPlace& place, const std::set<SymbolId>& letters) {
  static constexpr std::array<std::string_view, 6> between{"real",     "values",  "of",
                                                           "positive", "integer", "whole"};
  const auto& sentences = place.notes.prose.sentences;
  const auto own = std::ranges::find(sentences, beside(place).sentence, &ProseSentence::number);
  if (own == sentences.end()) return std::nullopt;
  const std::string text = lowered(own->text);
  const std::vector<std::string_view> words = words_of(text);
  std::size_t maths = 0;
  bool of_all = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] != "$") {
      const bool goes_on = of_all && (is_one_of(words[k], between) || is_general_noun(words[k]));
      const bool denied = k > 1 && is_one_of(words[k - 2], {"not", "never"});  // "does not hold for all"
      const bool denied_before = k > 2 && is_one_of(words[k - 3], {"not", "never"});
      of_all = goes_on || (means_all(words[k]) && !denied && !denied_before);
      continue;
    }
    if (maths >= own->maths.size()) break;
    const std::string_view written = without_blanks_around(place.sources.text(own->maths[maths++]));
    if (!std::exchange(of_all, false)) continue;
    for (const SymbolId each : letters) {
      const std::string& name = place.tree.symbols[each].name;
      const bool alone = written == name || (written.starts_with(name) && written.find(',') == name.size()) ||
                         (written.starts_with(name) && written.find("\\in") != std::string_view::npos);
      if (alone) return name;
    }
  }
  return std::nullopt;
}

bool is_bound(const Fact& fact) {
  return fact.equation.relation == Relation::less || fact.equation.relation == Relation::less_or_equal;
}

/// For which numbers the row is said: what its sentence or its display says, and what the section says of
/// signs and orders, "(x > 1)", "where $m$ is a mass". Nothing where neither says anything. What the section
/// says of several cases, "converges for $|x| < 1$ and diverges for $x > 1$", says nothing of the row.
std::optional<Names> with_what_is_said(RowPlace& place, const StepReading& row, const Claim& claim) {
  const Span display = span_of(place.notes.events[place.event]);
  const std::size_t sentence = beside(place).sentence;
  const auto is_of_its_sentence = [&](const Fact& fact) {
    if (fact.span.file == display.file && fact.span.begin >= display.begin && fact.span.end <= display.end)
      return true;
    return std::ranges::any_of(place.notes.prose.said, [&](const SaidInLine& said) {
      return said.sentence == sentence && said.span.file == fact.span.file &&
             said.span.begin == fact.span.begin;
    });
  };
  Names said_here = place.names;
  bool says = false;
  const auto add = [&says](Names& names, const Fact& fact) {
    assume(names.scope, {fact.equation, Origin{fact.text, {}, std::nullopt}, 0});
    says = true;
  };
  const Standpoint at = standpoint(place, row.parsed);
  for (const Fact& fact : at.facts) {
    if (!fact.elsewhere && (fact.proves || is_bound(fact)) && is_of_its_sentence(fact)) add(said_here, fact);
  }
  Names of_section = said_here;
  for (const Fact& fact : at.facts) {
    if (!fact.elsewhere && is_bound(fact) && !is_of_its_sentence(fact)) add(of_section, fact);
  }
  for (const NamedAssumption& each : sizes_said(place, claim)) {
    assume(of_section.scope, each);
    says = true;
  }
  if (!says) return std::nullopt;
  const bool of_one_case =
      sample_of_assumptions(place.tree, of_section, {}, limits_of_guesses, place.options.cache).has_value();
  return of_one_case ? of_section : said_here;
}

}  // namespace

void heed_existence(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (judgement.verdict != Verdict::proved || judgement.exists_under.empty()) return;
  std::vector<Equation> conditions = judgement.exists_under;
  if (const std::optional<Names> names = with_what_is_said(place, row, claim)) {
    Judgement said = judge(place.tree, *names, claim, {}, place.options.cache);
    if (said.verdict != Verdict::proved)
      return withdraw(
          judgement, claim,
          {.message = "it is said for numbers for which its sums or integrals may have no value"});
    conditions = std::move(said.exists_under);
  }
  std::set<SymbolId> letters;
  for (const Equation& condition : conditions)
    letters.merge(base_letters(place.tree, place.names.scope, condition));
  auto letter = letter_said_for_all(place, letters);
  const bool series = std::ranges::any_of(
      symbols_reached(place.tree, place.names.scope, {claim.equation.left, claim.equation.right}),
      [&](SymbolId each) {
        return place.tree.symbols[each].integral && place.tree.symbols[each].integral->sum;
      });
  const auto declared =
      std::ranges::find_if(letters, [&](SymbolId each) { return is_for_all(place.names.scope, each); });
  if (!letter && series && declared != letters.end()) letter = place.tree.symbols[*declared].name;
  if (letter)
    withdraw(judgement, claim,
             {.message = fmt::format("it is said for all `{}`, and its sums or integrals have a value only "
                                     "for some",
                                     *letter),
              .help = {"a condition next to it, as in `for |x| < 1`, says where they have one"}});
}

std::optional<Doubt> about_turning_axes(RowPlace& place, const Claim& claim) {
  const ExprTree& tree = place.tree;
  const std::vector<ExprId> nodes =
      nodes_reached(tree, place.names.scope, {claim.equation.left, claim.equation.right});
  const bool basis = std::ranges::any_of(nodes, [&](ExprId id) { return tree[id].op == Op::basis; });
  const bool rates = std::ranges::any_of(nodes, [&](ExprId id) {
    if (tree[id].op != Op::symbol) return false;
    const auto& derivation = tree.symbols[tree[id].symbol].derivation;
    return derivation &&
           std::ranges::any_of(derivation->by, [](const Variable& by) { return by == By::time; });
  });
  if (!basis || !rates) return std::nullopt;
  const auto word = word_of_turning_axes(place.notes.prose, place.event, place.section);
  if (!word) return std::nullopt;
  return Doubt{
      .message = fmt::format("the basis vectors are read as fixed, and `{}` may say that they turn", *word),
      .help = {"`rigor: frame … rotates with … in …` says how they turn"}};
}

}  // namespace rigor
