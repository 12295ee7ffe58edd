// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/state_facts.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "check/law/bearing.h"
#include "check/meaning/identity_reading.h"
#include "expr/tree/path.h"

namespace rigor {
namespace {

std::set<SymbolId> symbols_of(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> symbols;
  for (const ExprId side : {equation.left, equation.right}) {
    const std::vector<SymbolId> own = symbols_in(tree, side);
    symbols.insert(own.begin(), own.end());
  }
  return symbols;
}

/// With the letters that are varied and held.
std::set<SymbolId> letters_of(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> letters;
  for (const SymbolId symbol : symbols_of(tree, equation)) {
    letters.insert(base_of(tree.symbols, symbol));
    const auto& derivation = tree.symbols[symbol].derivation;
    if (!derivation || is_differential(tree.symbols, symbol)) continue;
    for (const Variable& by : derivation->by) letters.insert({by.letter, *by.held});
  }
  return letters;
}

bool is_form(const Symbol& symbol) { return symbol.name.starts_with("\\delta "); }

/// A plain number, a differential, or a derivative that holds a plain number by name.
bool is_of_states(const RowUnderLaws& row, SymbolId symbol) {
  const SymbolTable& symbols = row.tree.symbols;
  const auto is_plain = [&](SymbolId letter) {
    const Symbol& own = symbols[letter];
    return own.rank == 0 && !own.per_particle && !own.complex && !own.integral && !own.derivation &&
           !is_form(own) && !row.names.symbols.function_values.contains(letter);
  };
  if (!is_plain(base_of(symbols, symbol))) return false;
  const auto& derivation = symbols[symbol].derivation;
  if (!derivation || is_differential(symbols, symbol)) return true;
  return std::ranges::all_of(derivation->by, [&](const Variable& by) {
    return by.by == By::letter && by.partial && by.held && *by.held != by.letter && is_plain(by.letter) &&
           is_plain(*by.held);
  });
}

bool is_of_states(const RowUnderLaws& row, const Equation& equation) {
  if (equation.relation != Relation::equal || !equation.indices.empty() || !equation.particles.empty())
    return false;
  const auto is_scalar = [&](ExprId id) {
    const ExprNode& node = row.tree[id];
    return node.rank == 0 && node.op != Op::imaginary_unit && node.op != Op::index_sum &&
           node.op != Op::particle_sum && node.op != Op::table && node.slot_count == 0;
  };
  const std::set<SymbolId> symbols = symbols_of(row.tree, equation);
  return std::ranges::all_of(nodes_below(row.tree, {equation.left, equation.right}), is_scalar) &&
         std::ranges::all_of(symbols, [&](SymbolId each) { return is_of_states(row, each); });
}

/// The letter alone on its left side.
std::optional<SymbolId> letter_alone(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  const bool alone = left.op == Op::symbol && !tree.symbols[left.symbol].derivation;
  return alone ? std::optional(left.symbol) : std::nullopt;
}

/// Letters that nobody uses for a quantity of state: amounts, constants of nature and of a material. That the
/// section does not differentiate p of `U = 3pV/2` does not say that p is constant.
bool is_usual_constant(std::string_view letter) {
  static constexpr auto letters =
      std::to_array<std::string_view>({"a", "b", "c", "k", "m", "n", "N", "R", "\\gamma"});
  return is_one_of(letter, letters);
}

/// Does the section differentiate it, by anything or something by it? Of a letter that is no usual constant
/// this is not asked.
bool is_differentiated(const RowUnderLaws& row, SymbolId letter) {
  const Evidence& evidence = *row.names.symbols.evidence;
  const NameKey* key = key_of(row.names.symbols, letter);
  if (key == nullptr || evidence.speaks_of_change || is_changing(evidence, key->base) ||
      evidence.said_to_change.contains(without_labels(key->base)))
    return true;
  const std::string plain = without_labels(key->base);
  if (!is_usual_constant(plain)) return true;
  return std::ranges::any_of(evidence.by, [&](const auto& entry) {
    return entry.first == key->base || entry.first == plain ||
           entry.second.contains(changing_name(key->base));
  });
}

/// What the equation itself differentiates, varies or holds.
std::set<SymbolId> letters_of_derivatives(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> letters;
  for (const SymbolId symbol : symbols_of(tree, equation)) {
    const auto& derivation = tree.symbols[symbol].derivation;
    if (!derivation) continue;
    letters.insert(derivation->base);
    if (is_differential(tree.symbols, symbol)) continue;
    for (const Variable& by : derivation->by) letters.insert({by.letter, *by.held});
  }
  return letters;
}

/// Letters that are terms, U of `H = U + pV`: quantities like their sum, and no coefficients.
std::set<SymbolId> letters_as_terms(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> letters;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SignedTerm& term : signed_terms(tree, side)) {
      const ExprNode& node = tree[term.id];
      if (node.op == Op::symbol) letters.insert(base_of(tree.symbols, node.symbol));
    }
  }
  return letters;
}

/// What is differentiated, held or varied; what a letter alone is set equal to, and what could not change if
/// nothing else of its relation did: r of `V = 4\pi r^3/3`.
std::set<SymbolId> states_among(const RowUnderLaws& row, const StateFacts& facts) {
  const auto may_change = [&](SymbolId letter) {
    return !row.tree.symbols[letter].is_fixed() && !is_declared_constant(row.names.scope, letter);
  };
  std::set<SymbolId> states;
  for (const SymbolId letter : facts.letters) {
    if (may_change(letter) && is_differentiated(row, letter)) states.insert(letter);
  }
  states.merge(letters_of_derivatives(row.tree, row.claim.equation));
  for (const StateFact& fact : facts.facts) states.merge(letters_of_derivatives(row.tree, fact.equation));
  const std::set<SymbolId> differentiated = states;  // which C of `C = 3nR/2` need not be
  for (const StateFact& fact : facts.facts) {
    const std::set<SymbolId> terms = letters_as_terms(row.tree, fact.equation);
    std::ranges::copy_if(terms, std::inserter(states, states.end()), may_change);
  }
  const auto is_state = [&](SymbolId each) { return states.contains(each); };
  for (std::size_t before = facts.letters.size() + 1; before != states.size();) {
    before = states.size();
    for (const StateFact& fact : facts.facts) {
      const std::set<SymbolId> letters = letters_of(row.tree, fact.equation);
      const auto changing = std::ranges::count_if(letters, is_state);
      const auto alone = letter_alone(row.tree, fact.equation);
      if (alone && changing > 0) states.insert(*alone);
      const auto first = std::ranges::find_if(letters, is_state);
      if (changing == 1 && differentiated.contains(*first))
        std::ranges::copy_if(letters, std::inserter(states, states.end()), may_change);
    }
  }
  return states;
}

/// A relation between two letters only may be meant along one path: `pV = p_1V_1`, `dU = T\,dS`; where it is
/// said for a case, also `p = K/V`.
bool may_be_of_a_path(const RowUnderLaws& row, const StateFact& fact, const std::set<SymbolId>& states) {
  const Equation& equation = fact.equation;
  std::set<SymbolId> differentials;
  for (const SymbolId symbol : symbols_of(row.tree, equation)) {
    if (is_differential(row.tree.symbols, symbol)) differentials.insert(symbol);
  }
  if (!differentials.empty()) return differentials.size() < 3;
  if (letter_alone(row.tree, equation) && !fact.of_a_case) return false;
  const std::set<SymbolId> letters = letters_of(row.tree, equation);
  return std::ranges::count_if(letters, [&](SymbolId each) { return states.contains(each); }) < 3;
}

}  // namespace

std::set<SymbolId> letters_of_facts(const RowUnderLaws& row, const StateFacts& facts) {
  std::set<SymbolId> letters;
  for (const StateFact& fact : facts.facts) letters.merge(letters_of(row.tree, fact.equation));
  return letters;
}

namespace {

void take_letters(const RowUnderLaws& row, StateFacts& facts) {
  facts.letters = letters_of(row.tree, row.claim.equation);
  facts.letters.merge(letters_of_facts(row, facts));
}

/// The definitions that the letters lead to.
void add_definitions(const RowUnderLaws& row, StateFacts& facts) {
  std::set<SymbolId> known;
  for (bool grew = true; grew;) {
    grew = false;
    take_letters(row, facts);
    for (const SymbolId letter : facts.letters) {
      const NamedDefinition* named = definition_of(row.names.scope, letter);
      if (named == nullptr || !known.insert(letter).second) continue;
      const Definition& own = named->definition;
      const bool plain = own.indices.empty() && own.particle == no_particle && !own.by_square &&
                         !named->at_instant && !named->origin.conditional && !named->origin.of_a_case &&
                         !named->origin.on_its_line;
      const Equation equation = plain ? as_equation(row.tree, own) : Equation{};
      if (!plain || !is_of_states(row, equation)) continue;
      facts.facts.push_back({equation, named->origin.text});
      grew = true;
    }
  }
}

}  // namespace

bool has_differentials(const ExprTree& tree, const Equation& equation) {
  return std::ranges::any_of(symbols_of(tree, equation),
                             [&](SymbolId each) { return is_differential(tree.symbols, each); });
}

std::vector<Coordinates> coordinates_in(const ExprTree& tree, const Equation& equation) {
  std::vector<Coordinates> all;
  for (const SymbolId symbol : symbols_of(tree, equation)) {
    const auto& derivation = tree.symbols[symbol].derivation;
    if (!derivation) continue;
    for (const Variable& by : derivation->by) {
      if (by.by != By::letter || !by.held || *by.held == by.letter) continue;
      const Coordinates own{std::min(by.letter, *by.held), std::max(by.letter, *by.held)};
      if (!is_one_of(own, all)) all.push_back(own);
    }
  }
  return all;
}

std::optional<StateFacts> state_facts(const RowUnderLaws& row, const Laws& set) {
  if (!is_of_states(row, row.claim.equation)) return std::nullopt;
  StateFacts facts;
  for (const PageLaw* law : set) {
    if (law->at_instant || !is_of_states(row, law->equation)) continue;
    facts.facts.push_back({law->equation, law->name, law->of_a_case});
  }
  add_definitions(row, facts);
  take_letters(row, facts);
  facts.states = states_among(row, facts);
  std::erase_if(facts.facts,
                [&](const StateFact& fact) { return may_be_of_a_path(row, fact, facts.states); });
  return facts;
}

StateFacts only(const RowUnderLaws& row, const StateFacts& facts, const std::set<std::size_t>& which) {
  StateFacts some;
  for (const std::size_t each : which) some.facts.push_back(facts.facts[each]);
  take_letters(row, some);
  std::ranges::set_intersection(facts.states, some.letters, std::inserter(some.states, some.states.end()));
  return some;
}

}  // namespace rigor
