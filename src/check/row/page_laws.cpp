// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the laws above a row.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/average/average_meaning.h"
#include "check/average/average_value.h"
#include "check/law/from_laws.h"
#include "check/law/observables.h"
#include "check/place/place.h"
#include "check/question/base_letters.h"
#include "check/verdict/law_diagnostic.h"
#include "check/word/prose_words.h"
#include "expr/tree/path.h"

namespace rigor {
namespace {

void leave(RowPlace& place, const StepReading& row, const Claim& claim, Standing standing) {
  if (claim.nearly) return;
  Equation equation = claim.equation;
  if (states_values(place, row.parsed, row.reading))
    equation.right = row.reading.sides.back().typed->id;  // `u(0) = 0` of `u(0) = u(h) = 0`
  leave_to_rows_below(place, row.parsed, equation, claim.relation, standing);
}

/// Each is there once: results follow from results, and would double what they hold with each that follows.
void add_once(std::vector<std::string>& to, const std::vector<std::string>& more) {
  std::ranges::copy_if(more, std::back_inserter(to),
                       [&](const std::string& each) { return !is_one_of(each, to); });
}

/// A result holds where the laws do that it follows from.
void leave_result(RowPlace& place, const StepReading& row, const Claim& claim,
                  const std::vector<std::string>& uses) {
  const std::size_t before = place.found.stated.size();
  leave(place, row, claim, Standing::result);
  if (place.found.stated.size() == before) return;
  StatedLaw& result = place.found.stated.back();
  for (const StatedLaw& ground : place.above.stated) {
    if (!is_one_of(ground.law.name, uses)) continue;
    result.law.of_a_case = result.law.of_a_case || ground.law.of_a_case;
    add_once(result.beginnings, ground.beginnings);
    add_once(result.of_case.words, ground.of_case.words);
  }
}

/// It would follow from a conclusion that follows from nothing itself.
Judgement follows_from_open(const Laws& available, const Claim& claim, Judgement judgement) {
  const auto open = std::ranges::find_if(available, [&](const PageLaw* law) {
    return is_open(*law) && std::ranges::find(judgement.uses, law->name) != judgement.uses.end();
  });
  if (open == available.end()) return judgement;
  Judgement undecided;
  undecided.verdict = Verdict::undecided;
  undecided.uses = std::move(judgement.uses);
  undecided.used = std::move(judgement.used);
  undecided.diagnostics = {
      {DiagnosticKind::follows_from_nothing,
       claim.relation,
       fmt::format("it follows from `{}`, of which no proof was found", (*open)->name),
       {{(*open)->span, "not proved here"}},
       {"what that follows from can stand above it, as an equation or as `rigor: given …`"}}};
  return undecided;
}

/// "They are not Hermitian": then no commutator makes an operator of the section self-adjoint.
bool denies_self_adjoint_operators(const RowPlace& place) {
  return std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& sentence) {
    if (!place.notes.prose.sections.reaches(sentence.place, beside(place).place)) return false;
    const std::string text = lowered(sentence.text);
    if (text.find("complex scalar field") != std::string::npos ||
        text.find("complex field") != std::string::npos)
      return true;
    const std::vector<std::string_view> words = words_of(text);
    const auto has = [&](std::initializer_list<std::string_view> these) {
      return std::ranges::any_of(words, [&](std::string_view word) { return is_one_of(word, these); });
    };
    if (has({"non-hermitian", "nonhermitian", "non-self-adjoint", "anti-hermitian", "skew-hermitian"}))
      return true;
    return has({"hermitian", "self-adjoint", "observable", "observables"}) &&
           has({"not", "no", "never", "neither", "if", "any", "general", "whether"});
  });
}

/// `D^\dagger = D + i`
bool says_an_adjoint(const ExprTree& tree, const Equation& law, SymbolId letter) {
  return std::ranges::any_of(nodes_below(tree, {law.left, law.right}), [&](ExprId id) {
    if (tree[id].op != Op::conjugate) return false;
    const ExprNode& of = tree[tree.children(id)[0]];
    return of.op == Op::symbol && of.symbol == letter;
  });
}

/// Does `a^\dagger` stand in the row, in a law or in a definition? Then a is no observable, but for
/// `\hat p^\dagger = \hat p`.
bool is_daggered(const RowPlace& place, const Claim& claim, const Laws& available, SymbolId letter) {
  const ExprTree& tree = place.tree;
  const auto is_it = [&](ExprId id) { return tree[id].op == Op::symbol && tree[id].symbol == letter; };
  const auto daggers = [&](const Equation& equation) {
    const auto is_own_adjoint = [&](ExprId one, ExprId other) {
      return tree[one].op == Op::conjugate && is_it(tree.children(one)[0]) && is_it(other);
    };
    if (is_own_adjoint(equation.left, equation.right) && tree.symbols[letter].name.starts_with("\\hat"))
      return false;
    return std::ranges::any_of(
        nodes_reached(tree, place.names.scope, {equation.left, equation.right}),
        [&](ExprId id) { return tree[id].op == Op::conjugate && is_it(tree.children(id)[0]); });
  };
  return daggers(claim.equation) ||
         std::ranges::any_of(available, [&](const PageLaw* law) { return daggers(law->equation); });
}

/// That the operators of the row are self-adjoint, as far as the words or the commutators of the page say so.
std::vector<PageLaw> self_adjoint_letters(RowPlace& place, const Claim& claim, const Laws& available) {
  const auto writes = [&](const Equation& each) {
    return writes_adjoints(place.tree, place.names.scope, each);
  };
  const bool operators =
      has_operators(place.tree, claim.equation.left) || has_operators(place.tree, claim.equation.right);
  if (!operators) return {};
  const auto is_written_by = [&](const PageLaw* law) { return writes(law->equation); };
  if (!writes(claim.equation) && std::ranges::none_of(available, is_written_by)) return {};
  std::map<SymbolId, std::string> names;
  const bool denied = denies_self_adjoint_operators(place);
  if (!denied) {
    for (const SymbolId letter : observables_of(place.tree, available))
      names[letter] = "convention: `{}` is self-adjoint, as an observable is";
  }
  const ProseBeside& here = beside(place);
  for (const LetterInLine& said : place.notes.prose.self_adjoint) {
    if (denied || !place.notes.prose.sections.reaches(said.place, here.place)) continue;
    const auto reading = read_here(place, said.chain);
    if (reading->sides.size() != 2 || !reading->sides[1].typed) continue;
    const ExprNode& letter = place.tree[reading->sides[1].typed->id];
    if (letter.op == Op::symbol && letter.slot_count == 0)
      names[letter.symbol] = "`{}` is said to be self-adjoint";
  }
  // "For Hermitian operators $X$ and any $Z$" names those that are.
  const bool of_all = here.lead.find('$') == std::string::npos && speaks_of_self_adjoint_operators(here.lead);
  std::vector<PageLaw> laws;
  for (const SymbolId letter : base_letters(place.tree, place.names.scope, claim.equation)) {
    const Symbol& symbol = place.tree.symbols[letter];
    if (!symbol.noncommuting || symbol.rank > 0 || definition_of(place.names.scope, letter) != nullptr)
      continue;
    if (is_daggered(place, claim, available, letter)) continue;
    // What the page says of its adjoint goes before a convention.
    const bool told = std::ranges::any_of(
        available, [&](const PageLaw* law) { return says_an_adjoint(place.tree, law->equation, letter); });
    if (told) continue;
    const auto said = names.find(letter);
    if (said == names.end() && !of_all) continue;
    const std::string text = said != names.end() ? said->second : "`{}` is said to be self-adjoint";
    laws.push_back(
        self_adjoint_law(place.tree, letter, claim.relation, fmt::format(fmt::runtime(text), symbol.name)));
  }
  return laws;
}

/// The letters that change in time and that these lead to: r of `u = 1/r` where the page has `\dot r`.
std::vector<SymbolId> moving_letters(const RowPlace& place, SymbolId symbol) {
  std::vector<SymbolId> moving;
  const ExprTree& tree = place.tree;
  const auto body = body_of_definition(place.names.scope, symbol);
  const std::vector<SymbolId> reached =
      body ? symbols_reached(tree, place.names.scope, {*body}) : std::vector{symbol};
  for (const SymbolId each : reached) {
    const SymbolId base = base_of(tree.symbols, each);
    const NameKey* key = key_of(place.names.symbols, base);
    const bool moves = key != nullptr && key->rank == 0 && has_rate(*place.names.symbols.sightings, *key) &&
                       definition_of(place.names.scope, base) == nullptr;
    if (moves && !is_one_of(base, moving)) moving.push_back(base);
  }
  return moving;
}

/// `\dot r = \frac{dr}{d\theta}\dot\theta`, where the row has a derivative by \theta, and \theta changes in
/// time: what is a function of it changes as it does. Of each order that the row has.
std::vector<PageLaw> laws_along_the_motion(RowPlace& place, const Claim& claim) {
  ExprTree& tree = place.tree;
  const Span span = claim.relation;
  const auto node = [&](SymbolId symbol) {
    return tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
  };
  std::vector<PageLaw> laws;
  for (const ExprId side : {claim.equation.left, claim.equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const std::optional<Derivation> derivation = tree.symbols[symbol].derivation;
      if (!derivation) continue;
      const Variable by = *derivation->by.begin();
      const bool total =
          by.by == By::letter && !by.partial && !by.held && derivation->by.count(by) == derivation->by.size();
      if (!total || moving_letters(place, by.letter) != std::vector{by.letter}) continue;
      for (const SymbolId letter : moving_letters(place, derivation->base)) {
        SymbolId of = letter;
        for (std::size_t order = 0; order < derivation->by.size() && letter != by.letter; ++order) {
          const SymbolId next = tree.symbols.derivative(of, by);
          const ExprId factors[] = {node(next), node(tree.symbols.derivative(by.letter, By::time))};
          PageLaw law{.equation = {}, .name = {}, .span = span, .by_convention = true};
          law.equation.left = node(tree.symbols.derivative(of, By::time));
          law.equation.right = tree.add({.op = Op::multiply, .span = span}, factors);
          law.name = fmt::format("convention: `{}` is a function of `{}`, which changes in time",
                                 tree.symbols[of].name, tree.symbols[by.letter].name);
          laws.push_back(std::move(law));
          of = next;
        }
      }
    }
  }
  return laws;
}

/// Is it `\dot A` or, by a letter, `dA/dc`: of the first order, with nothing held?
std::optional<Variable> only_variable(const SymbolTable& symbols, SymbolId symbol) {
  const auto& derivation = symbols[symbol].derivation;
  if (!derivation || derivation->by.size() != 1 || is_differential(symbols, symbol)) return std::nullopt;
  const Variable& by = *derivation->by.begin();
  const bool total = by == By::time || (by.by == By::letter && !by.partial && !by.held);
  return total ? std::optional(by) : std::nullopt;
}

/// dm, dV, dl, dq: elements of a body. What relates them need not be a change in time.
bool is_an_element(const Names& names, SymbolId letter) {
  const NameKey* key = key_of(names.symbols, letter);
  const std::set<std::string> elements{"m", "M", "V", "A",       "S",     "l",     "\\ell",   "s", "q",
                                       "Q", "N", "n", "\\Omega", "\\Phi", "\\tau", "\\sigma", "I", "B"};
  return key == nullptr || elements.contains(key->base);
}

/// `dI = r^2\,dm`, `d\Phi = B\,dA`, `dN = f\,dv`: what the sum over a body is made of.
bool relates_elements(const Names& names, const ExprTree& tree, const Claim& claim, const Laws& above) {
  const auto relates = [&](const Equation& equation) {
    const ExprNode& left = tree[equation.left];
    const bool names_one = left.op == Op::symbol && is_differential(tree.symbols, left.symbol);
    const NameKey* named = names_one ? key_of(names.symbols, base_of(tree.symbols, left.symbol)) : nullptr;
    if (named != nullptr && is_one_of(named->base, {"N", "n", "m", "M", "q", "V", "I", "F", "B", "\\Phi"}))
      return true;
    return std::ranges::any_of(std::array{equation.left, equation.right}, [&](ExprId side) {
      return std::ranges::any_of(symbols_in(tree, side), [&](SymbolId each) {
        const bool is_named = side == equation.left && names_one;
        return !is_named && is_differential(tree.symbols, each) &&
               is_an_element(names, base_of(tree.symbols, each));
      });
    });
  };
  return relates(claim.equation) ||
         std::ranges::any_of(above, [&](const PageLaw* law) { return relates(law->equation); });
}

/// `dA = \dot A`, `dt = 1`, where the row or its laws have rates beside differentials: these hold along every
/// path, so also along the motion, whose parameter is the time. The same by a letter: `dA/dc` beside `dA` and
/// `dc`.
std::vector<PageLaw> laws_along_a_path(RowPlace& place, const Claim& claim, Laws above) {
  ExprTree& tree = place.tree;
  std::erase_if(above, [&](const PageLaw* law) {  // other sections have paths of their own
    return !place.notes.prose.sections.reaches(law->place, beside(place).place);
  });
  std::set<SymbolId> written;
  const auto see = [&](const Equation& equation) {
    for (const ExprId side : {equation.left, equation.right}) {
      for (const SymbolId each : symbols_in(tree, side)) written.insert(each);
    }
  };
  see(claim.equation);
  const std::set<SymbolId> own = written;
  for (const PageLaw* law : above) see(law->equation);
  std::set<SymbolId> differentials;
  std::ranges::copy_if(written, std::inserter(differentials, differentials.end()),
                       [&](SymbolId each) { return is_differential(tree.symbols, each); });
  if (differentials.empty()) return {};
  std::optional<Variable> parameter;
  for (const std::set<SymbolId>& symbols : {own, written}) {
    for (const SymbolId each : symbols) {
      if (!parameter) parameter = only_variable(tree.symbols, each);
    }
  }
  const auto is_time = [&](SymbolId letter) {
    const NameKey* key = key_of(place.names.symbols, letter);
    return key != nullptr && key->base == "t";
  };
  const auto base = [&](SymbolId differential) { return base_of(tree.symbols, differential); };
  const bool in_a_time = std::ranges::any_of(differentials, is_time, base);
  if (!parameter && in_a_time) parameter = By::time;
  if (!in_a_time && relates_elements(place.names, tree, claim, above)) return {};
  if (!parameter) return {};
  const Span span = claim.relation;
  std::vector<PageLaw> laws;
  for (const SymbolId each : differentials) {
    const bool in_time = *parameter == By::time;
    const bool is_parameter = in_time ? is_time(base(each)) : base(each) == parameter->letter;
    const SymbolId rate = tree.symbols.derivative(base(each), *parameter);
    PageLaw law{.equation = {}, .name = {}, .span = span, .by_convention = true, .proves_only = true};
    law.equation.left = tree.add({.op = Op::symbol, .span = span, .symbol = each});
    law.equation.right = is_parameter ? tree.add_number(span, "1")
                                      : tree.add({.op = Op::symbol, .span = span, .symbol = rate});
    law.name = fmt::format("`{}` along the path, by {}", tree.symbols[each].name,
                           in_time ? "the time" : fmt::format("`{}`", tree.symbols[parameter->letter].name));
    laws.push_back(std::move(law));
  }
  return laws;
}

/// "With $b = d$ we get", "for $\theta_1 + \theta_2 = \pi/2$": what its own sentence says goes with the laws.
/// `above`: among which it may be already.
std::vector<PageLaw> said_in_its_sentence(RowPlace& place, const StepReading& row, const Laws& above) {
  const ProseBeside& here = beside(place);
  std::set<std::uint32_t> own;  // where its relations begin
  for (const SaidInLine& said : place.notes.prose.said) {
    if (said.sentence == here.sentence && !said.chains.empty()) own.insert(said.span.begin);
  }
  for (const DefinitionBehind& each : definitions_behind(place, row.parsed))
    own.insert(each.chain->written.span.begin);
  std::vector<PageLaw> laws;
  if (own.empty()) return laws;
  for (const Fact& fact : standpoint(place, row.parsed).facts) {
    const bool is_own = own.contains(fact.span.begin) && !fact.elsewhere;
    const bool known =
        std::ranges::any_of(above, [&](const PageLaw* law) { return law->span.begin == fact.span.begin; });
    if (!fact.proves || !is_own || known || fact.equation.relation != Relation::equal) continue;
    laws.push_back({.equation = fact.equation,
                    .name = fact.text,
                    .span = fact.span,
                    .place = fact.place,
                    .argument = here.argument,
                    .at_instant = fact.at_instant,
                    .of_a_case = !is_about_values(place, fact.equation)});
  }
  return laws;
}

}  // namespace

bool is_open(const PageLaw& law) { return law.standing == Standing::conclusion; }

bool is_announced(const RowPlace& place, const StepReading& row) {
  const bool is_link = row.which > 0 && !states_values(place, row.parsed, row.reading);
  return is_link || row.parsed.written.inference != Inference::none ||
         says_that_it_follows(beside(place).lead);
}

namespace {

/// `\langle E^2\rangle = \sum_s p_sE_s^2` beside the law `\langle E\rangle = \sum_s p_sE_s`, for the
/// averages of the row of which no law says what they are. The nearest law of the section counts.
std::vector<PageLaw> averages_by_their_meaning(RowPlace& place, const Claim& claim, const Laws& available) {
  ExprTree& tree = place.tree;
  std::vector<PageLaw> laws;
  const auto says = [&](const PageLaw* law, SymbolId symbol) {
    const ExprNode& left = tree[law->equation.left];
    return left.op == Op::symbol && left.symbol == symbol;
  };
  for (const SymbolId symbol :
       symbols_reached(tree, place.names.scope, {claim.equation.left, claim.equation.right})) {
    if (!is_average(tree, symbol) || tree.symbols[symbol].derivation ||
        std::ranges::any_of(available, [&](const PageLaw* law) { return says(law, symbol); }))
      continue;
    for (auto law = available.rbegin(); law != available.rend(); ++law) {
      const bool stated = (*law)->standing == Standing::law && !(*law)->at_instant && !(*law)->of_a_case &&
                          place.notes.prose.sections.reaches((*law)->place, beside(place).place);
      auto meaning = stated ? meaning_of_average(tree, place.names, symbol, (*law)->equation) : std::nullopt;
      if (!meaning) continue;
      laws.push_back(**law);
      laws.back().equation = *std::move(meaning);
      break;
    }
  }
  return laws;
}

/// "For the second state", "in the ground state": another one than above.
bool speaks_of_a_state(const std::string& lead) {
  const std::string text = lowered(lead);
  return std::ranges::any_of(words_of(text), [](std::string_view word) {
    return is_one_of(word,
                     {"state", "states", "level", "second", "third", "other", "another", "excited", "next"});
  });
}

}  // namespace

Grounds grounds_of(RowPlace& place, const StepReading& row, const Claim& claim) {
  const Laws above = available_to(place, row.parsed);
  std::vector<PageLaw> own = self_adjoint_letters(place, claim, above);
  std::ranges::move(laws_along_the_motion(place, claim), std::back_inserter(own));
  std::ranges::move(laws_along_a_path(place, claim, above), std::back_inserter(own));
  // "For the second state": another weight.
  if (!may_be_of_a_case(place, row.parsed) && !speaks_of_a_state(beside(place).lead))
    std::ranges::move(averages_by_their_meaning(place, claim, above), std::back_inserter(own));
  const std::size_t conventions = own.size();
  std::ranges::move(said_in_its_sentence(place, row, above), std::back_inserter(own));
  Grounds grounds{.own = std::make_shared<const std::vector<PageLaw>>(std::move(own))};
  for (std::size_t k = conventions; k < grounds.own->size(); ++k)
    grounds.of_its_sentence.push_back(&(*grounds.own)[k]);
  grounds.all.all = above;
  for (const PageLaw& each : *grounds.own) grounds.all.all.push_back(&each);
  grounds.founded.all = grounds.all.all;
  std::erase_if(grounds.founded.all, [](const PageLaw* law) { return is_open(*law); });
  for (AvailableLaws* laws : {&grounds.all, &grounds.founded}) {
    laws->named = named_beside(place, laws->all);
    std::ranges::copy(grounds.of_its_sentence, std::back_inserter(laws->named));
  }
  return grounds;
}

bool follows_from_page(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (row.role != Role::display || row.unsettled || is_meant_for_all(place.tree, place.names, claim))
    return false;
  const Grounds grounds = grounds_of(place, row, claim);
  DecisionCache& cache = *place.options.cache;
  const bool inferred = is_announced(place, row);
  auto found = follow_from_laws(place.tree, place.names, claim, grounds.founded, inferred, cache);
  const bool rests_on_open =
      !found && is_announced(place, row) && grounds.founded.all.size() < grounds.all.all.size();
  if (rests_on_open) found = follow_from_laws(place.tree, place.names, claim, grounds.all, inferred, cache);
  if (!found) return false;
  add_used(place, judgement.used);
  judgement = *std::move(found);
  add_used(place, judgement.used);
  if (rests_on_open) {
    judgement = follows_from_open(grounds.all.all, claim, std::move(judgement));
    leave(place, row, claim, Standing::conclusion);
    return true;
  }
  if (judgement.restates) return true;
  heed_proof(place, row.parsed, claim, judgement);
  const bool both_ways = row.parsed.written.inference == Inference::equivalence;
  // What holds where its own sentence does need not hold below, but for initial values.
  const bool of_its_sentence = std::ranges::any_of(grounds.of_its_sentence, [&](const PageLaw* law) {
    return law->of_a_case && is_one_of(law->name, judgement.uses);
  });
  if (judgement.verdict == Verdict::proved && !both_ways && !of_its_sentence)
    leave_result(place, row, claim, judgement.uses);
  return true;
}

namespace {

/// "and so $\omega^2 = k/m$", where nothing has spoken of \omega: it names it, as `\omega = \sqrt{k/m}`
/// would.
bool names_a_square(const RowPlace& place, const StepReading& row, const Claim& claim) {
  const ExprTree& tree = place.tree;
  const ExprNode& left = tree[claim.equation.left];
  if (row.which > 0 || claim.equation.relation != Relation::equal || left.op != Op::power ||
      left.exponent != 2)
    return false;
  const ExprNode& letter = tree[tree.children(claim.equation.left)[0]];
  return letter.op == Op::symbol && letter.rank == 0 && letter.slot_count == 0 &&
         !tree.symbols[letter.symbol].derivation &&
         definition_of(place.names.scope, letter.symbol) == nullptr &&
         !seen_in_equation(place.names.scope, letter.symbol) &&
         !is_one_of(letter.symbol, symbols_in(tree, claim.equation.right));
}

}  // namespace

void state_law(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (is_suspect(place, row, claim, judgement)) return;
  if (is_denied_by_laws(place.tree, place.names, claim, available_to(place, row.parsed),
                        *place.options.cache)) {
    judgement.verdict = Verdict::undecided;
    judgement.diagnostics.push_back(without_ground(place.tree, place.names, claim, judgement));
    return;
  }
  // Who assumes something about its letters means it to follow from that.
  if (place.is_stated || names_a_square(place, row, claim) ||
      (!judgement.despite_given && !is_announced(place, row))) {
    judgement.route = "stated; it follows from nothing above it";
    return leave(place, row, claim, Standing::law);
  }
  judgement.verdict = Verdict::undecided;
  judgement.diagnostics.push_back(without_ground(place.tree, place.names, claim, judgement));
  leave(place, row, claim, Standing::conclusion);
}

}  // namespace rigor
