// SPDX-License-Identifier: GPL-3.0-or-later
// What a row takes from the laws above it, and what it leaves to the rows below it.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/law/from_laws.h"
#include "check/place/place.h"
#include "check/verdict/law_diagnostic.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// Its letters mean what they meant where the law was stated: none was defined anew since.
bool means_the_same(const RowPlace& place, const StatedLaw& stated) {
  const Equation& equation = stated.law.equation;
  const std::vector<SymbolId> letters =
      symbols_reached(place.tree, stated.scope, {equation.left, equation.right});
  return std::ranges::all_of(letters, [&](SymbolId letter) {
    const auto then = body_of_definition(stated.scope, letter);
    return !then || then == body_of_definition(place.names.scope, letter);
  });
}

/// Above in this section or one around it; of earlier sections, what is not said for a case or an example.
bool is_available(const RowPlace& place, const StatedLaw& stated) {
  const ProseBeside& here = beside(place);
  const Sections& sections = place.notes.prose.sections;
  const PageLaw& law = stated.law;
  if (law.of_a_case && law.paragraph != here.paragraph) return false;
  const bool reaches = sections.reaches(law.place, here.place);
  if (!reaches && (stated.of_a_section || sections.leaves_an_example(law.place, here.place))) return false;
  return means_the_same(place, stated);
}

/// `\omega_0 = 5.0\,\mathrm{s^{-1}}`: a letter and a number, of an example.
bool is_value(const ExprTree& tree, const Equation& equation) {
  const auto is_number = [&](ExprId side) {
    const std::vector<SymbolId> symbols = symbols_in(tree, side);
    return !tree.is_zero_literal(side) && std::ranges::all_of(symbols, [&](SymbolId each) {
      return tree.symbols[each].unit_of_measure.has_value();
    });
  };
  return is_number(equation.left) || is_number(equation.right);
}

/// "Example 3", "Exercises": what is stated there holds there.
bool is_headed_as_example(const RowPlace& place) {
  static constexpr std::array<std::string_view, 8> heads{"example", "examples", "exercise", "exercises",
                                                         "problem", "problems", "question", "questions"};
  const std::string heading = lowered(place.section);
  return std::ranges::any_of(words_of(heading), [](std::string_view word) { return is_one_of(word, heads); });
}

/// `\mathbf r = (r, \theta, \phi)`: these need not be components along Cartesian axes.
bool names_coordinates(const ExprTree& tree, const Equation& equation) {
  return tree[equation.left].op == Op::symbol && tree[equation.right].op == Op::tuple;
}

void leave(RowPlace& place, const StepReading& row, const Claim& claim, std::string_view word) {
  if (claim.nearly || claim.equation.relation != Relation::equal || is_alternative(place, row.parsed) ||
      names_coordinates(place.tree, claim.equation))
    return;
  const ProseBeside& here = beside(place);
  place.found.stated.push_back(
      {{claim.equation, name_of_law(row.parsed.written.tag, claim.relation, place.sources, word),
        claim.relation, here.place, here.paragraph,
        is_conditional(place) || is_value(place.tree, claim.equation)},
       place.names.scope,
       is_of_a_case(place) || is_headed_as_example(place)});
}

}  // namespace

bool follows_from_page(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (row.role != Role::display || row.unsettled || is_meant_for_all(place.tree, place.names, claim))
    return false;
  std::vector<const PageLaw*> available;
  for (const StatedLaw& stated : place.above.stated) {
    const Span at = stated.law.span;
    const Span own = row.parsed.written.span;
    const bool of_this_chain = at.file == own.file && at.begin >= own.begin && at.end <= own.end;
    if (!of_this_chain && is_available(place, stated)) available.push_back(&stated.law);
  }
  auto found = follow_from_laws(place.tree, place.names, claim, available, *place.options.cache);
  if (!found) return false;
  add_used(place, judgement.used);
  judgement = std::move(found->judgement);
  add_used(place, judgement.used);
  if (found->restated != nullptr) return true;
  heed_proof(place, row.parsed, claim, judgement);
  if (judgement.verdict == Verdict::proved) leave(place, row, claim, "result");
  return true;
}

void state_law(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  // Who assumes something about its letters means it to follow from that.
  if (row.which == 0 && !judgement.despite_given && !says_that_it_follows(beside(place).lead)) {
    judgement.route = "stated; it follows from nothing above it";
    return leave(place, row, claim, "law");
  }
  judgement.verdict = Verdict::undecided;
  judgement.diagnostics.push_back(without_ground(place.tree, place.names, claim, judgement));
}

}  // namespace rigor
