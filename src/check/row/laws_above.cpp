// SPDX-License-Identifier: GPL-3.0-or-later
// What rows, and relations in lines of prose, leave to the rows below them, and where that holds.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/meaning/identity_reading.h"
#include "check/meaning/measured.h"
#include "check/place/place.h"
#include "check/question/base_letters.h"
#include "check/question/running_letters.h"
#include "check/word/place_words.h"
#include "check/word/problem_words.h"
#include "check/word/prose_words.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/name/function_value.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

/// What the letters of an equation mean, where they are defined.
std::vector<std::pair<SymbolId, ExprId>> meanings_of(const RowPlace& place, const Equation& equation) {
  std::vector<std::pair<SymbolId, ExprId>> meanings;
  for (const SymbolId letter :
       symbols_reached(place.tree, place.names.scope, {equation.left, equation.right})) {
    if (const auto body = body_of_definition(place.names.scope, letter)) meanings.emplace_back(letter, *body);
  }
  return meanings;
}

/// Its letters mean what they meant where the law was stated: none was defined anew since.
bool means_the_same(const RowPlace& place, const StatedLaw& stated) {
  return std::ranges::all_of(stated.meanings, [&](const auto& meaning) {
    return body_of_definition(place.names.scope, meaning.first) == meaning.second;
  });
}

/// `R + T = 1`
bool is_one(const ExprTree& tree, const Equation& equation) {
  const auto one = [&](ExprId side) { return tree[side].op == Op::number && tree.digits(side) == "1"; };
  return one(equation.left) || one(equation.right);
}

/// `\omega_0 = 5.0\,\mathrm{s^{-1}}`: a letter and a number, of an example. A commutator that is a number
/// holds for good, and so does `R + T = 1`.
bool is_value(const ExprTree& tree, const Equation& equation) {
  if (has_operators(tree, equation.left) || has_operators(tree, equation.right)) return false;
  if (is_one(tree, equation) && written_letters(tree, equation).size() > 1) return false;
  const auto is_number = [&](ExprId side) { return !tree.is_zero_literal(side) && is_measured(tree, side); };
  return is_number(equation.left) || is_number(equation.right);
}

/// `x^2 - 5x + 6 = 0`: it says what one letter is worth, and another equation may say it of another thing.
bool determines_a_letter(const ExprTree& tree, const Equation& equation) {
  const std::set<SymbolId> letters = written_letters(tree, equation);
  const auto is_plain = [&](SymbolId each) {
    const Symbol& symbol = tree.symbols[each];
    return symbol.rank == 0 && !symbol.noncommuting && !symbol.integral && !symbol.derivation;
  };
  const auto differentiates = [&](ExprId side) {
    return std::ranges::any_of(symbols_in(tree, side),
                               [&](SymbolId each) { return tree.symbols[each].derivation.has_value(); });
  };
  return letters.size() == 1 && is_plain(*letters.begin()) && !differentiates(equation.left) &&
         !differentiates(equation.right);
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
  return tree[equation.left].op == Op::symbol && tree[equation.right].op == Op::tuple &&
         !tree.is_zero_literal(equation.right);
}

/// `\mathbf J = 0` where the notes differentiate by place: a field that vanishes does so at all times.
bool says_that_a_field_vanishes(const RowPlace& place, const Equation& equation) {
  const ExprNode& left = place.tree[equation.left];
  if (left.op != Op::symbol || !place.tree.is_zero_literal(equation.right)) return false;
  const NameKey* key = key_of(place.names.symbols, left.symbol);  // none of a derivative
  const Sightings& sightings = *place.names.symbols.sightings;
  return key != nullptr && sightings.places && !has_rate(sightings, *key);
}

/// `v = \dot x`; not `\dot x = v_0`, which may be how it starts.
bool names_a_rate(const ExprTree& tree, const Equation& equation) {
  const auto is_rate = [&](ExprId side) {
    return tree[side].op == Op::symbol && tree.symbols[tree[side].symbol].derivation.has_value();
  };
  const auto is_name = [&](ExprId side) {
    return tree[side].op == Op::symbol && !is_rate(side) &&
           !tree.symbols[tree[side].symbol].name.ends_with("_{0}");
  };
  return (is_rate(equation.left) && is_name(equation.right)) ||
         (is_name(equation.left) && is_rate(equation.right));
}

bool has_integral(const ExprTree& tree, ExprId side) {
  return tree[side].op == Op::symbol && tree.symbols[tree[side].symbol].integral.has_value();
}

/// `\dot x = 0`, `x = a`, `\phi_1 = \phi_2`: letters and nothing else.
bool sets_letters_equal(const ExprTree& tree, const Equation& equation) {
  const auto is_bare = [&](ExprId side) {
    return tree[side].op == Op::symbol || tree[side].op == Op::number;
  };
  const bool bare = (is_bare(equation.left) || tree.is_zero_literal(equation.left)) &&
                    (is_bare(equation.right) || tree.is_zero_literal(equation.right));
  return bare && !names_a_rate(tree, equation);
}

/// The letters that are factors of a term, the first one and the last one.
struct Factors {
  std::set<SymbolId> letters;
  std::optional<SymbolId> beginning = {};
  std::optional<SymbolId> ending = {};
  bool plain = true;  // neither a quotient nor a power
};

Factors factors_of_term(const ExprTree& tree, ExprId term) {
  if (tree[term].op == Op::symbol) return {{tree[term].symbol}, tree[term].symbol, tree[term].symbol};
  Factors factors;
  if (tree[term].op == Op::divide) factors = factors_of_term(tree, tree.children(term)[0]);
  factors.plain = tree[term].op != Op::divide && tree[term].op != Op::power;
  if (tree[term].op != Op::multiply) return factors;
  for (const ExprId factor : tree.children(term)) {
    const Factors own = factors_of_term(tree, factor);
    if (factor == tree.children(term).front()) factors.beginning = own.beginning;
    factors.letters.insert(own.letters.begin(), own.letters.end());
    factors.plain = factors.plain && own.plain;
    factors.ending = own.ending;
  }
  return factors;
}

/// `H\psi = E\psi`, `Pu = Pv`: who does not cancel what ends the terms, or a capital that begins them, does
/// not mean a product of numbers. `mg = ma`, `mv^2/r = GMm/r^2` and `Mv^2 = Mgh` are some.
bool keeps_an_operator(const RowPlace& place, const Equation& equation) {
  if (holds_states(place.tree, equation.left) || holds_states(place.tree, equation.right)) return false;
  std::vector<Factors> terms;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SignedTerm& term : signed_terms(place.tree, side))
      terms.push_back(factors_of_term(place.tree, term.id));
  }
  const auto is_product = [](const Factors& term) { return term.letters.size() > 1; };
  if (std::ranges::none_of(terms, is_product)) return false;  // `S_{ij} = S_{ji}`
  return std::ranges::any_of(terms.front().letters, [&](SymbolId each) {
    const NameKey* key = key_of(place.names.symbols, each);
    const bool capital = key != nullptr && is_capital_letter(without_labels(key->base));
    return std::ranges::all_of(terms, [&](const Factors& term) { return term.ending == each; }) ||
           (capital && std::ranges::all_of(
                           terms, [&](const Factors& term) { return term.beginning == each && term.plain; }));
  });
}

/// The letter that a law says alone on its left side what it is: F of `F = -kx`.
std::optional<SymbolId> letter_of_law(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  const bool alone = left.op == Op::symbol && !tree.symbols[left.symbol].derivation;
  return alone ? std::optional(left.symbol) : std::nullopt;
}

/// Its tag, without brackets, and its label; no empty ones.
std::vector<std::string> labels_of(const WrittenChain& written) {
  std::string tag = written.tag;
  std::erase_if(tag, [](char c) { return c == '(' || c == ')'; });
  std::vector<std::string> labels{std::move(tag), written.label};
  std::erase(labels, "");
  return labels;
}

/// Does the sentence name it, "with (1.3)"?
bool is_named_beside(const RowPlace& place, const StatedLaw& stated) {
  const std::string& lead = beside(place).lead;
  static constexpr std::array<std::string_view, 5> contrasts{"compar", "replac", "unlike", "instead",
                                                             "contrast"};
  if (std::ranges::any_of(contrasts,
                          [&](std::string_view stem) { return lead.find(stem) != std::string::npos; }))
    return false;
  return std::ranges::any_of(beside(place).references,
                             [&](const std::string& each) { return is_one_of(each, stated.labels); });
}

/// Its left side, and the first term of that: `m\ddot x` of `m\ddot x + kx = 0`. The rate in this term says
/// what it is an equation of: `\ddot x = -\omega^2x` is one of the same letter.
std::vector<std::string> beginnings_of_law(ExprTree& tree, const Equation& equation) {
  const ExprId first = signed_terms(tree, equation.left).front().id;
  std::vector<std::string> beginnings{dump(tree, equation.left), dump(tree, first)};
  const std::vector<ExprId> factors =
      tree[first].op == Op::multiply ? std::vector(tree.children(first).begin(), tree.children(first).end())
                                     : std::vector{first};
  for (const ExprId factor : factors) {
    const ExprNode& node = tree[factor];
    if (node.op == Op::symbol && tree.symbols[node.symbol].derivation)
      beginnings.push_back(dump(tree, factor));
  }
  return beginnings;
}

/// `U = RI` defines U, and "a coil has" `U = L\dot I`: both need not be about one thing.
bool is_of_another_thing(const RowPlace& place, const StatedLaw& stated) {
  if (!stated.letter || !stated.law.of_its_own) return false;
  const NamedDefinition* named = definition_of(place.names.scope, *stated.letter);
  return named != nullptr && !named->origin.directive;
}

/// `m\ddot x + kx = 0` of "Undamped", where "Damped" begins another law so.
bool is_stated_anew(const StatedLaw& stated, const std::set<std::string>& here) {
  return std::ranges::any_of(stated.beginnings, [&](const std::string& each) { return here.contains(each); });
}

/// Where a law may be used.
struct Reach {
  bool one_of_several = false;               // `F = -kx` and `F = mg`: each of them holds in its paragraph
  std::vector<std::string> conditions;       // that are said of the row
  const std::set<std::string>& stated_here;  // how the laws of this section begin
  const CasesNamed& cases;                   // that are named above the row
  bool of_any_thing = false;                 // also what may be of another thing than the letter's definition
};

/// "A hollow cylinder has twice the moment of inertia": what a letter of another display is need not hold.
bool speaks_of_another_thing_since(const RowPlace& place, std::size_t sentence) {
  const std::size_t here = beside(place).sentence;
  const auto is_its_own = [](std::string_view word) { return word != "with" && has_own_words(word); };
  const std::vector<ProseSentence>& sentences = place.notes.prose.sentences;
  auto each = std::ranges::upper_bound(sentences, sentence, {}, &ProseSentence::number);
  for (; each != sentences.end() && each->number <= here; ++each) {
    const std::string text = lowered(each->text);
    if (std::ranges::any_of(words_of(text), is_its_own)) return true;
  }
  return false;
}

/// "We insert this": the display right above its sentence.
bool is_pointed_at(const RowPlace& place, const PageLaw& law) {
  if (!points_at_the_row_above(beside(place).lead)) return false;
  std::size_t event = place.event;
  while (event > 0 && place.notes.prose.beside[event].sentence == beside(place).sentence) --event;
  const auto* above = std::get_if<ParsedDisplay>(&place.notes.events[event]);
  return above != nullptr && std::ranges::any_of(above->chains, [&](const ParsedChain& chain) {
           const Span of = chain.written.span;
           return of.file == law.span.file && of.begin <= law.span.begin && law.span.end <= of.end;
         });
}

/// Above in this section or one around it; of earlier sections, what is not said for a case or an example. A
/// case holds in its paragraph, and where it is named; under a condition, where that is said as well.
bool is_available(const RowPlace& place, const StatedLaw& stated, const Reach& reach) {
  const ProseBeside& here = beside(place);
  const Sections& sections = place.notes.prose.sections;
  const PageLaw& law = stated.law;
  const bool said = std::ranges::all_of(
      stated.conditions, [&](const std::string& each) { return is_one_of(each, reach.conditions); });
  if (!said || (stated.poses && names_another_thing(here.lead))) return false;
  if (stated.explained_in && speaks_of_another_thing_since(place, *stated.explained_in)) return false;
  const bool in_reach =
      law.argument == here.argument || is_named_beside(place, stated) || is_pointed_at(place, law);
  if (!in_reach && (law.of_a_case || reach.one_of_several)) return false;
  const bool reaches = sections.reaches(law.place, here.place);
  if (!reaches && (stated.of_a_section || stated.poses || sections.leaves_an_example(law.place, here.place) ||
                   is_stated_anew(stated, reach.stated_here)))
    return false;
  if (!reach.of_any_thing && is_of_another_thing(place, stated) && !is_named_beside(place, stated))
    return false;
  if (!means_the_same(place, stated)) return false;
  return !reach.cases.names_another_since(stated.of_case) || is_named_beside(place, stated);
}

/// `z = \zeta(x, y)` where derivatives by place are written: a surface, and elsewhere z is another number.
bool names_a_surface(const RowPlace& place, const Equation& equation) {
  const auto letter = letter_of_law(place.tree, equation);
  return letter && is_free_variable(place.names, place.tree, *letter, By::space);
}

/// It speaks of a letter that is one thing here and another there, and nothing says which case is meant.
bool is_of_an_unknown_case(const RowPlace& place, const Equation& equation) {
  const std::vector<SymbolId> letters =
      symbols_reached(place.tree, place.names.scope, {equation.left, equation.right});
  return std::ranges::any_of(place.above.cases, [&](const CaseDefinition& each) {
    return place.notes.prose.sections.reaches(each.place, beside(place).place) &&
           definition_of(place.names.scope, each.definition.symbol) == nullptr &&
           is_one_of(each.definition.symbol, letters);
  });
}

/// `E_r = \rho r/3\epsilon_0 \quad (r < R)`: where, when or in which case it holds, as it is written next to
/// it.
std::vector<std::string> conditions_said(const RowPlace& place, const ParsedChain& parsed) {
  std::vector<std::string> conditions;
  for (const ParsedChain& each : parsed.assumed) conditions.push_back(text_of(each.written));
  for (const ParsedChain* each : conditions_beside(place, parsed))
    conditions.push_back(text_of(each->written));
  return conditions;
}

std::string_view word_of(Standing standing) {
  static constexpr std::array<std::string_view, 3> words{"law", "result", "conclusion"};
  return words[static_cast<std::size_t>(standing)];
}

}  // namespace

bool is_of_a_moment(const RowPlace& place) {
  static constexpr auto moments = std::to_array<std::string_view>(
      {"when",    "where",   "whenever", "initially",   "boundary", "surface", "interface", "edge",
       "wall",    "top",     "bottom",   "turning",     "instant",  "moment",  "meet",      "meets",
       "reaches", "reached", "vanishes", "maximum",     "minimum",  "once",    "until",     "after",
       "before",  "during",  "starts",   "ends",        "stops",    "axis",    "conductor", "however",
       "clamped", "fixed",   "rest",     "equilibrium", "grounded", "finally"});
  static constexpr std::array<std::string_view, 5> all{"all", "any", "every", "each", "least"};
  const std::string lead = lowered(beside(place).lead);
  const std::vector<std::string_view> words = words_of(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool lasts = words[k] == "fixed" && k > 0 && words[k - 1] == "of";  // "a force of fixed amplitude"
    if (is_one_of(words[k], moments) && !lasts) return true;
    const bool rate = k > 0 && words[k - 1] == "rate";  // "the rate at which"
    if (words[k] == "at" && !rate && (k + 1 == words.size() || !is_one_of(words[k + 1], all))) return true;
  }
  const std::string tail = lowered(beside(place).tail);
  const std::vector<std::string_view> behind = words_of(tail);
  return !behind.empty() && (behind[0] == "at" || behind[0] == "when" || behind[0] == "initially");
}

namespace {

/// "There is no charge on the axis", also behind the display: "on the axis."
bool is_of_a_spot(const RowPlace& place) {
  if (names_a_spot(beside(place).lead)) return true;
  const std::string& tail = beside(place).tail;
  const std::vector<std::string_view> behind = words_of(tail);
  return !behind.empty() && is_one_of(behind[0], {"on", "along", "in"}) && names_a_spot(tail);
}

/// Has it a rate, or a letter that may change?
bool speaks_of_change(const RowPlace& place, const Equation& equation) {
  return std::ranges::any_of(std::array{equation.left, equation.right}, [&](ExprId side) {
    return std::ranges::any_of(symbols_in(place.tree, side), [&](SymbolId symbol) {
      const NameKey* key = key_of(place.names.symbols, symbol);
      return key == nullptr || may_be_changing(*place.names.symbols.evidence, key->base);
    });
  });
}

}  // namespace

bool is_about_values(const RowPlace& place, const Equation& equation) {
  const Evidence& evidence = *place.names.symbols.evidence;
  const auto is_letter = [&](ExprId side) { return place.tree[side].op == Op::symbol; };
  const bool names = is_letter(equation.left) && is_letter(equation.right);
  bool found = false;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(place.tree, side)) {
      if (is_function_value(place.names, place.tree, symbol)) {
        found = true;
        continue;
      }
      const NameKey* key = key_of(place.names.symbols, symbol);
      if (key == nullptr) return false;
      const bool changes =
          names ? evidence.applied.contains(key->base) || has_rate(*place.names.symbols.sightings, *key)
                : may_be_changing(evidence, key->base);
      if (changes) return false;
    }
  }
  return found;
}

namespace {

/// `\langle m|n\rangle`, and what it is for all states of a set.
bool is_product_of_states(const ExprTree& tree, ExprId side) {
  const auto is_ket = [&](ExprId id) {
    return tree[id].op == Op::symbol && tree.symbols[tree[id].symbol].ket;
  };
  const ExprNode& node = tree[side];
  return node.op == Op::multiply && node.count == 2 && is_ket(tree.children(side)[1]) &&
         tree[tree.children(side)[0]].op == Op::conjugate && is_ket(tree.children(tree.children(side)[0])[0]);
}

/// `\langle 0|1\rangle = 0`, `\langle m|n\rangle = \delta_{mn}`: how states are chosen, once for all.
bool chooses_states(const ExprTree& tree, const Equation& equation) {
  const ExprNode& right = tree[equation.right];
  return is_product_of_states(tree, equation.left) &&
         (right.op == Op::number ||
          (right.op == Op::symbol && is_kronecker_of_states(tree.symbols[right.symbol])));
}

}  // namespace

bool states_values(const RowPlace& place, const ParsedChain& parsed, const ChainReading& reading) {
  const std::size_t last = reading.sides.size() - 1;
  if (last < 2 || !std::ranges::all_of(parsed.written.relations, [](const WrittenRelation& each) {
        return each.kind == RelationKind::equal;
      }))
    return false;
  const auto is_value = [&](const ChainReading::Side& side) {
    const ExprTree& tree = place.tree;
    if (side.typed && is_product_of_states(tree, side.typed->id)) return true;
    return side.typed && tree[side.typed->id].op == Op::symbol &&
           !tree.symbols[base_of(tree.symbols, tree[side.typed->id].symbol)].integral &&
           is_function_value(place.names, tree, tree[side.typed->id].symbol);
  };
  return std::all_of(reading.sides.begin(), reading.sides.end() - 1, is_value) && reading.sides[last].typed &&
         !is_value(reading.sides[last]);
}

bool says_values_at_a_moment(const RowPlace& place, const Equation& equation) {
  const bool somewhere = is_of_a_moment(place) || is_of_a_spot(place);
  if (!somewhere || says_that_it_follows(beside(place).lead)) return false;
  const ExprTree& tree = place.tree;
  if (sets_letters_equal(tree, equation))
    return !has_integral(tree, equation.left) && !has_integral(tree, equation.right);
  // `x_1 = x_2 + h`: two of a kind meet.
  const auto name = [&](ExprId id) {
    return tree[id].op == Op::symbol ? without_labels(tree.symbols[tree[id].symbol].name) : std::string();
  };
  const auto is_of_its_kind = [&](const SignedTerm& term) { return name(term.id) == name(equation.left); };
  return !name(equation.left).empty() && tree[equation.right].op == Op::add &&
         std::ranges::any_of(signed_terms(place.tree, equation.right), is_of_its_kind);
}

bool is_an_example(const RowPlace& place) {
  const std::string lead = lowered(beside(place).lead);
  return std::ranges::any_of(words_of(lead), [](std::string_view word) {
    return is_one_of(word, {"instance", "example"});
  });
}

void leave_to_rows_below(RowPlace& place, const ParsedChain& parsed, const Equation& equation, Span relation,
                         Standing standing) {
  if (equation.relation != Relation::equal || is_alternative(place, parsed) ||
      names_coordinates(place.tree, equation) || keeps_an_operator(place, equation) ||
      names_a_surface(place, equation) || is_of_an_unknown_case(place, equation) ||
      (parsed.written.doubt && !parsed.written.only_said_for))
    return;
  const ProseBeside& here = beside(place);
  const bool beside_an_arrow = parsed.written.premise || parsed.written.inference != Inference::none;
  const bool momentary = is_of_a_moment(place) || asks_directly(here.lead);
  const bool operators =
      has_operators(place.tree, equation.left) || has_operators(place.tree, equation.right);
  // `a = x_0` that was found to follow is no case.
  const bool sets = sets_letters_equal(place.tree, equation) &&
                    (standing != Standing::result || speaks_of_change(place, equation));
  const bool of_values = is_about_values(place, equation);
  const auto is_of_this_case = [&](const StatedLaw& each) {
    return each.law.of_a_case && each.law.argument == here.argument;
  };
  const bool in_a_case =
      announces_a_conclusion(here.lead) && std::ranges::any_of(place.above.stated, is_of_this_case);
  // `V(r) = -k/r` holds for each r, whatever rests somewhere.
  const auto letter = letter_of_law(place.tree, equation);
  const bool runs =
      letter && !runs_along(place.names, place.tree, {.symbol = *letter, .body = equation.right}).empty();
  const bool lasts = of_values || runs ||
                     (!momentary && !is_of_a_spot(place) && says_that_a_field_vanishes(place, equation));
  PageLaw law{
      .equation = equation,
      .name = name_of_law(parsed.written.tag, relation, place.sources, word_of(standing)),
      .span = relation,
      .place = here.place,
      .argument = here.argument,
      .at_instant = (momentary || sets) && !lasts,
      .of_a_case = in_a_case || ((momentary || sets) && !of_values && !runs) || is_an_example(place) ||
                   beside_an_arrow ||
                   (is_of_a_passing_case(place, !operators) && !chooses_states(place.tree, equation)) ||
                   is_value(place.tree, equation) || determines_a_letter(place.tree, equation),
      .of_its_own = has_own_words(here.lead.substr(here.lead.rfind('\n') + 1)),
      .proves_only = !operators && is_one(place.tree, equation),
      .standing = standing};
  place.found.stated.push_back({.law = std::move(law),
                                .labels = labels_of(parsed.written),
                                .beginnings = beginnings_of_law(place.tree, equation),
                                .conditions = conditions_said(place, parsed),
                                .of_a_section = is_of_a_case(place) || is_headed_as_example(place),
                                .of_case = case_said_at(place.notes.prose, place.event, place.section),
                                .letter = letter,
                                .meanings = meanings_of(place, equation)});
}

namespace {

/// May it speak of a function, by a rate or a value? So few lines do that the others need not be read.
bool may_speak_of_a_function(const SyntaxTree& syntax, const ParsedChain& chain) {
  return std::ranges::any_of(nodes_below(syntax, chain.sides), [&](SyntaxId id) {
    if (syntax[id].kind == SyntaxKind::derivative) return true;
    if (syntax[id].kind == SyntaxKind::symbol)
      return syntax.symbol(id).dots > 0 || syntax.symbol(id).primes > 0;
    return syntax[id].kind == SyntaxKind::term && syntax.children(id).size() > 1 &&
           syntax[syntax.children(id)[1].id].kind == SyntaxKind::group;
  });
}

/// `y'' - y' - 6y = 0`; not `\dot\theta = 0`, which may hold for a moment, nor `v = \dot x`.
bool is_differential_equation(const ExprTree& tree, const Equation& equation) {
  const auto is_rate = [&](SymbolId each) {
    const auto& derivation = tree.symbols[each].derivation;
    return derivation && tree.symbols[each].rank == 0 &&
           std::ranges::all_of(derivation->by,
                               [](const Variable& by) { return by != By::small && !by.held; });
  };
  const std::vector<SymbolId> left = symbols_in(tree, equation.left);
  const std::vector<SymbolId> right = symbols_in(tree, equation.right);
  return !sets_letters_equal(tree, equation) && !names_a_rate(tree, equation) &&
         (std::ranges::any_of(left, is_rate) || std::ranges::any_of(right, is_rate));
}

/// `Ae^{\lambda t}`, and not `\gamma mv`, which says what a momentum is.
bool has_a_function(const ExprTree& tree, ExprId side) {
  return std::ranges::any_of(nodes_below(tree, {side}),
                             [&](ExprId id) { return tree[id].op == Op::function; });
}

/// "$$x' = \gamma(x - vt)$$ with $\gamma = …$": the letter stands in the display that it is said of.
bool explains_its_display(const RowPlace& place, const SaidInLine& said,
                          const std::set<std::string>& letter) {
  const std::vector<ProseBeside>& beside = place.notes.prose.beside;
  for (std::size_t k = std::min(said.before, beside.size());
       k-- > 0 && beside[k].sentence == said.sentence;) {
    const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      const std::set<std::string> written = letters_written_in(place.notes.syntax, chain.sides);
      if (std::ranges::includes(written, letter)) return true;
    }
  }
  return false;
}

/// x of `\ddot x` and `dx/dt` on the page, y of `y''` and `dy/dx` in the section.
bool is_differentiated(const RowPlace& place, SymbolId letter) {
  const NameKey* key = key_of(place.names.symbols, letter);
  if (key == nullptr) return false;
  const Evidence& evidence = *place.names.symbols.evidence;
  return has_rate(*place.names.symbols.sightings, *key) || evidence.primed.contains(key->base) ||
         std::ranges::any_of(
             evidence.by, [&](const auto& each) { return each.second.contains(changing_name(key->base)); });
}

StatedLaw stated_in_line(RowPlace& place, const SaidInLine& said, const Equation& equation, bool of_a_case,
                         std::string_view words) {
  PageLaw law{
      .equation = equation,
      .name = fmt::format("{} (line {})", written_at(place, said.span),
                          place.sources.line_column(said.span.file, said.span.begin).line),
      .span = said.span,
      .place = said.place,
      .argument = said.argument,
      .of_a_case = of_a_case || said.in_passing || word_that_demands(words) || word_of_a_special_case(words),
      .proves_only = said.in_passing};
  return {.law = std::move(law),
          .of_a_section = is_of_a_case(place) || is_headed_as_example(place),
          .of_case = case_said_in(place.notes.prose, said.sentence, place.section),
          .letter = letter_of_law(place.tree, equation),
          .meanings = meanings_of(place, equation)};
}

/// "With $y(0) = y'(0) = 0$": each value by itself.
void leave_values_said(RowPlace& place, const SaidInLine& said, const ParsedChain& chain,
                       const std::string& sentence) {
  const auto reading = read_here(place, chain);
  if (!states_values(place, chain, *reading) || turns_a_problem_down(sentence)) return;
  for (std::size_t k = 0; k + 1 < reading->sides.size(); ++k) {
    Diagnostics ignored;
    const auto claim =
        reading->claim(chain, 0, *reading->sides[k].typed, *reading->sides.back().typed, false, ignored);
    if (!claim || !ignored.empty() || !is_about_values(place, claim->equation)) continue;
    StatedLaw stated = stated_in_line(place, said, claim->equation, false, lowered(sentence));
    stated.poses = true;
    place.found.stated.push_back(std::move(stated));
  }
}

}  // namespace

void leave_what_a_line_says(RowPlace& place, const SaidInLine& said) {
  if (said.cue == Cue::apart) return;
  const std::vector<ProseSentence>& sentences = place.notes.prose.sentences;
  const auto sentence = std::ranges::find(sentences, said.sentence, &ProseSentence::number);
  if (sentence == sentences.end() || sentence->asks) return;
  const bool may_name = said.cue == Cue::definition && !said.at_place;
  const bool may_try = may_name || (said.cue == Cue::none && speaks_of_a_trial(sentence->text));
  for (const ParsedChain& chain : said.chains) {
    const bool plain = !chain.written.condition && !chain.written.doubt;
    if (chain.sides.size() > 2 && plain && may_speak_of_a_function(place.notes.syntax, chain))
      leave_values_said(place, said, chain, sentence->text);
    if (chain.sides.size() != 2 || chain.written.relations[0].kind != RelationKind::equal || !plain ||
        !(may_name || may_try || may_speak_of_a_function(place.notes.syntax, chain)))
      continue;
    const auto reading = read_here(place, chain);
    if (!reading->sides[0].typed || !reading->sides[1].typed || guess_of(reading->reading())) continue;
    Diagnostics ignored;
    const auto claim = reading->claim(chain, 0, false, ignored);
    if (!claim || !ignored.empty()) continue;
    const Equation& equation = claim->equation;
    const bool for_now = sets_letters_equal(place.tree, equation) || is_measured(place.tree, equation.right);
    const auto letter = letter_of_law(place.tree, equation);
    // "With $N = a^\dagger a$" says what a new letter is; of a known one it may say a case, but for "where".
    const bool is_new = letter && !seen_in_equation(place.names.scope, *letter);
    const bool explains =
        letter && !is_new && !symbols_in(place.tree, equation.right).empty() &&
        explains_its_display(place, said, letters_written_in(place.notes.syntax, {chain.sides[0]}));
    const bool brings_in = may_name && (is_new || explains) && sentence->has_display &&
                           is_said_for_good(place, said, *letter) &&
                           definition_of(place.names.scope, *letter) == nullptr;
    const bool names = may_name && !for_now && letter && (said.named || brings_in) &&
                       !names_coordinates(place.tree, equation) && !keeps_an_operator(place, equation) &&
                       !names_a_surface(place, equation);
    const bool tries = may_try && !for_now && letter && is_differentiated(place, *letter) &&
                       has_a_function(place.tree, equation.right);
    const bool of_values = is_about_values(place, equation);
    const bool says =
        of_values || tries || (!said.at_place && is_differential_equation(place.tree, equation));
    const bool poses = says && !turns_a_problem_down(sentence->text, tries);
    if (!names && !poses) continue;
    const std::string words = lowered(sentence->text);
    StatedLaw stated = stated_in_line(place, said, equation, !(names || of_values), words);
    stated.law.names_a_letter = brings_in;
    stated.poses = poses;
    if (names && explains) stated.explained_in = said.sentence;
    place.found.stated.push_back(std::move(stated));
  }
}

Laws available_to(const RowPlace& place, const ParsedChain& parsed, bool of_any_thing) {
  struct Times {
    int here = 0;  // in this section or one around it
    int anywhere = 0;
  };
  std::map<SymbolId, Times> said;  // how often the page says what a letter is; a result says it again
  const auto is_here = [&](const StatedLaw& stated) {
    return place.notes.prose.sections.reaches(stated.law.place, beside(place).place);
  };
  std::set<std::string> stated_here;
  for (const StatedLaw& stated : place.above.stated) {
    if (stated.law.standing == Standing::law && is_here(stated))
      stated_here.insert(stated.beginnings.begin(), stated.beginnings.end());
    if (!stated.letter || stated.law.standing == Standing::result) continue;
    Times& times = said[*stated.letter];
    ++times.anywhere;
    if (is_here(stated)) ++times.here;
  }
  const std::vector<std::string> conditions = conditions_said(place, parsed);
  const CasesNamed cases(place.notes.prose, place.event, place.section);
  Laws available;
  for (const StatedLaw& stated : place.above.stated) {
    const Span at = stated.law.span;
    const Span own = parsed.written.span;
    const bool of_this_chain = at.file == own.file && at.begin >= own.begin && at.end <= own.end;
    const bool says = stated.letter && stated.law.standing != Standing::result;
    const Times times = says ? said[*stated.letter] : Times{};
    const Reach reach{(is_here(stated) ? times.here : times.anywhere) > 1, conditions, stated_here, cases,
                      of_any_thing};
    if (!of_this_chain && is_available(place, stated, reach)) available.push_back(&stated.law);
  }
  return available;
}

Laws named_beside(const RowPlace& place, const Laws& available) {
  Laws named;
  for (const StatedLaw& stated : place.above.stated) {
    if (is_named_beside(place, stated) && is_one_of(&stated.law, available)) named.push_back(&stated.law);
  }
  return named;
}

}  // namespace rigor
