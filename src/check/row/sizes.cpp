// SPDX-License-Identifier: GPL-3.0-or-later
// `2\pi\sqrt{a^3/GM} = 2\pi a\sqrt{a/GM}` holds for a radius: a quantity that the page calls a mass, a length
// or a frequency is positive. That is a convention, which the verdict names, so it is asked only where a root
// leaves a row open. And what words hold, "at constant temperature".
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/place/place.h"
#include "check/question/base_letters.h"
#include "check/repair/repair.h"
#include "check/word/held_words.h"
#include "check/word/prose_words.h"
#include "check/word/sizes.h"

namespace rigor {
namespace {

/// Does it matter to some part whether its letters are negative?
bool asks_for_signs(const RowPlace& place, const std::vector<Equation>& equations) {
  std::vector<ExprId> roots;
  for (const Equation& each : equations) roots.insert(roots.end(), {each.left, each.right});
  return std::ranges::any_of(nodes_reached(place.tree, place.names.scope, std::move(roots)), [&](ExprId id) {
    const ExprNode& node = place.tree[id];
    return node.op == Op::root || node.op == Op::absolute || node.op == Op::real_power ||
           (node.op == Op::function && node.function == Function::log);
  });
}

NamedAssumption positive(RowPlace& place, Span span, SymbolId letter, std::string_view why) {
  Equation order;
  order.left = place.tree.add_number(span, "0");
  order.right = place.tree.add({.op = Op::symbol, .span = span, .symbol = letter});
  order.relation = Relation::less;
  std::string says = fmt::format("convention: `{}` is positive, as {}", place.tree.symbols[letter].name, why);
  return {std::move(order), Origin{std::move(says), {}, std::nullopt}, 0};
}

/// "The effective mass is negative near the top", "a length of either sign", "degrees Celsius": then no word
/// makes a letter positive.
bool speaks_of_signs(const RowPlace& place, std::size_t here) {
  return std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& sentence) {
    if (!place.notes.prose.sections.reaches(sentence.place, here)) return false;
    const std::string text = lowered(sentence.text);
    return std::ranges::any_of(words_of(text), [](std::string_view word) {
      return is_one_of(word, {"negative", "sign", "signs", "imaginary", "difference", "differences", "change",
                              "changes", "reduced", "celsius", "focal", "scattering", "slip", "effective",
                              "quantum", "component", "components", "complex"});
    });
  });
}

/// Of the letters of the row and of the laws that it may follow from, those that are called a size here, and
/// the constants of nature. What is assumed of a letter goes before a convention.
std::vector<NamedAssumption> sizes_of(RowPlace& place, const Claim& claim,
                                      const std::vector<Equation>& equations) {
  std::set<SymbolId> letters;
  for (const Equation& each : equations) {
    letters.merge(base_letters(place.tree, place.names.scope, each));
    for (const SymbolId reached : symbols_reached(place.tree, place.names.scope, {each.left, each.right})) {
      if (definition_of(place.names.scope, reached) != nullptr) letters.insert(reached);  // `a = p/(1 - e^2)`
    }
  }
  for (const NamedAssumption& each : place.names.scope.assumptions) {
    for (const SymbolId letter : base_letters(place.tree, place.names.scope, each.equation))
      letters.erase(letter);
  }
  std::vector<NamedAssumption> sizes;
  for (const SymbolId letter : letters) {
    const Symbol& symbol = place.tree.symbols[letter];
    if (symbol.rank == 0 && is_positive_constant(symbol.name))
      sizes.push_back(positive(place, claim.relation, letter, "that constant is"));
  }
  const std::size_t here = beside(place).place;
  if (speaks_of_signs(place, here)) return sizes;
  for (const LetterInLine& said : place.notes.prose.sizes) {
    if (!place.notes.prose.sections.reaches(said.place, here)) continue;
    const auto reading = read_here(place, said.chain);
    if (!reading->sides[0].typed) continue;
    const ExprNode& node = place.tree[reading->sides[0].typed->id];
    const bool letter = node.op == Op::symbol && node.rank == 0 && node.slot_count == 0;
    if (!letter || !letters.erase(node.symbol)) continue;  // once
    sizes.push_back(positive(place, claim.relation, node.symbol,
                             said.noun.empty() ? "the notes say" : fmt::format("a {} is", said.noun)));
  }
  return sizes;
}

}  // namespace

std::vector<NamedAssumption> sizes_said(RowPlace& place, const Claim& claim) {
  return sizes_of(place, claim, {claim.equation});
}

std::vector<NamedAssumption> sizes_that_matter(RowPlace& place, const StepReading& row, const Claim& claim) {
  std::vector<Equation> equations{claim.equation};
  for (const PageLaw* law : available_to(place, row.parsed)) equations.push_back(law->equation);
  return asks_for_signs(place, equations) ? sizes_of(place, claim, equations)
                                          : std::vector<NamedAssumption>{};
}

bool follows_for_sizes(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::undecided || judgement.verdict == Verdict::law;
  if (!open || row.role != Role::display || row.unsettled || claim.recorded != nullptr ||
      is_meant_for_all(place.tree, place.names, claim))
    return false;
  const std::vector<NamedAssumption> sizes = sizes_that_matter(place, row, claim);
  if (sizes.empty()) return false;
  const Names before = place.names;
  for (const NamedAssumption& each : sizes) assume(place.names.scope, each);
  // A letter that is defined as a size need not be one.
  if (!sample_of_assumptions(place.tree, place.names, {}, limits_of_guesses, place.options.cache)) {
    place.names = before;
    return false;
  }
  Judgement under = judge_here(place, claim);
  bool found = under.verdict == Verdict::proved;
  if (found) heed_proof(place, row.parsed, claim, under);
  if (!found) found = follows_from_page(place, row, claim, under);
  place.names = before;
  if (found) judgement = std::move(under);
  return found;
}

namespace {

/// The text of a `$` of a sentence.
std::string_view maths_of(const RowPlace& place, const ProseSentence& sentence, std::size_t which) {
  return which < sentence.maths.size() ? without_blanks_around(place.sources.text(sentence.maths[which]))
                                       : std::string_view{};
}

/// T of "temperature", where the page calls one letter so: the last above that does, of the own section if
/// there is one.
std::string letter_called(const RowPlace& place, std::string_view noun) {
  std::string letter;
  bool of_own = false;
  for (const ProseSentence& sentence : place.notes.prose.sentences) {
    if (sentence.number > beside(place).sentence) break;
    const bool own = place.notes.prose.sections.reaches(sentence.place, beside(place).place);
    const auto called = own || !of_own ? maths_called(sentence.text, noun) : std::nullopt;
    if (!called) continue;
    letter = maths_of(place, sentence, *called);
    of_own = own;
  }
  return letter;
}

/// The names of what the words before the row hold: "at constant $T$".
std::set<std::string> names_held(const RowPlace& place) {
  const std::string& lead = beside(place).lead;
  const std::size_t begin = lead.rfind('\n') == std::string::npos ? 0 : lead.rfind('\n') + 1;
  const HeldByWords held = held_by_words(std::string_view(lead).substr(begin));
  std::set<std::string> names;
  for (const std::string& noun : held.nouns) names.insert(letter_called(place, noun));
  const auto& sentences = place.notes.prose.sentences;
  const auto own = std::ranges::find(sentences, beside(place).sentence, &ProseSentence::number);
  const auto earlier = std::count(lead.begin(), lead.begin() + static_cast<std::ptrdiff_t>(begin), '$');
  for (const std::size_t which : held.maths) {
    if (own != sentences.end())
      names.insert(std::string(maths_of(place, *own, static_cast<std::size_t>(earlier) + which)));
  }
  names.erase("");  // a noun that the page calls no letter
  return names;
}

}  // namespace

bool follows_with_letters_held(RowPlace& place, const StepReading& row, const Claim& claim,
                               Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::undecided || judgement.verdict == Verdict::law;
  if (!open || row.role != Role::display || row.unsettled || claim.recorded != nullptr ||
      is_meant_for_all(place.tree, place.names, claim))
    return false;
  const std::set<std::string> held = names_held(place);
  if (held.empty()) return false;
  const Names before = place.names;
  std::vector<std::string> conventions;
  for (const SymbolId each : base_letters(place.tree, place.names.scope, claim.equation)) {
    const Symbol& symbol = place.tree.symbols[each];
    const bool letter = symbol.rank == 0 && !symbol.integral && !symbol.derivation && !symbol.is_fixed();
    if (!letter || !held.contains(symbol.name) || definition_of(place.names.scope, each) != nullptr) continue;
    declare_constant(place.names.scope, each, std::nullopt);
    conventions.push_back(fmt::format("`{}` is constant, as the words before it say", symbol.name));
  }
  if (conventions.empty()) return false;
  const std::size_t stated = place.found.stated.size();
  Judgement under = judge_here(place, claim);
  bool found = under.verdict == Verdict::proved;
  if (found) heed_proof(place, row.parsed, claim, under);
  if (!found) found = follows_from_page(place, row, claim, under) && under.verdict == Verdict::proved;
  place.names = before;
  // What follows from it holds where it is held.
  for (std::size_t k = stated; k < place.found.stated.size(); ++k) place.found.stated[k].law.of_a_case = true;
  if (!found) {
    place.found.stated.erase(place.found.stated.begin() + static_cast<std::ptrdiff_t>(stated),
                             place.found.stated.end());
    return false;
  }
  under.uses.insert(under.uses.end(), conventions.begin(), conventions.end());
  judgement = std::move(under);
  return true;
}

}  // namespace rigor
