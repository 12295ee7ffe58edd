// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/states.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/law/state_facts.h"
#include "check/law/surface.h"
#include "check/meaning/identity_reading.h"
#include "check/question/decision_cache.h"

namespace rigor {
namespace {

constexpr Limits limits_of_states{
    .expanded_terms = 20'000, .steps = 200'000, .sample_attempts = 1, .only_proofs = true};
constexpr Limits limits_of_witness{
    .expanded_terms = 20'000, .steps = 200'000, .sample_attempts = 24, .simplest_sample = false};
constexpr std::size_t most_coordinates = 4;

/// What is asked of derivatives along the coordinates.
struct Asked {
  std::vector<Equation> claims;  // one, or of a relation between differentials one for each coordinate
  std::vector<Equation> assumptions;
  std::vector<std::size_t> facts;  // of each assumption, which fact says so
  std::vector<ExprId> divisors;
  std::vector<SymbolId> not_zero;  // assumed behind all others
};

int order_of(const ExprTree& tree, const Equation& equation) {
  int order = 0;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side))
      order = std::max(order, tree.symbols[symbol].order());
  }
  return order;
}

/// D_v of what holds along u, less D_u of what holds along v: the second derivatives cancel.
Equation mixed(ExprTree& tree, Surface& surface, const Equation& along_u, const Equation& along_v) {
  const auto less = [&](ExprId of_u, ExprId of_v) {
    const ExprId first = surface.along(of_u, 1);
    const ExprId second = surface.along(of_v, 0);
    const Span span = tree[of_u].span;
    const std::array terms{first, tree.add({.op = Op::negate, .span = span}, std::span(&second, 1))};
    return tree.add({.op = Op::add, .span = span}, terms);
  };
  Equation result = along_u;
  result.left = less(along_u.left, along_v.left);
  result.right = less(along_u.right, along_v.right);
  return result;
}

/// Nothing where a derivative cannot be told, or derivatives grow too large.
std::optional<Asked> asked_on(const RowUnderLaws& row, Surface& surface, const StateFacts& facts) {
  ExprTree& tree = row.tree;
  Asked asked;
  const Equation& claim = row.claim.equation;
  for (const int which : {0, 1}) {
    if (which == 1 && !has_differentials(tree, claim)) break;
    const auto own = surface.rewritten(claim, which);
    if (!own) return std::nullopt;
    asked.claims.push_back(*own);
  }
  int order = 1;
  for (const Equation& each : asked.claims) order = std::max(order, order_of(tree, each));
  const auto push = [&](const Equation& equation, std::size_t fact) {
    asked.assumptions.push_back(equation);
    asked.facts.push_back(fact);
  };
  // With its derivatives, as far as the claim goes.
  const auto push_all = [&](const Equation& equation, std::size_t fact) {
    std::vector<Equation> round{equation};
    for (int own = order_of(tree, equation); !round.empty(); ++own) {
      for (const Equation& each : round) push(each, fact);
      std::vector<Equation> next;
      for (std::size_t k = 0; own < order && k < round.size(); ++k) {
        if (k == 0) next.push_back(surface.along(round[k], 0));
        next.push_back(surface.along(round[k], 1));
      }
      round = std::move(next);
    }
  };
  for (std::size_t k = 0; k < facts.facts.size(); ++k) {
    const Equation& equation = facts.facts[k].equation;
    const auto along_u = surface.rewritten(equation, 0);
    if (!along_u) continue;
    push_all(*along_u, k);
    if (!has_differentials(tree, equation)) continue;
    const auto along_v = surface.rewritten(equation, 1);
    if (!along_v) return std::nullopt;
    push_all(*along_v, k);
    push(mixed(tree, surface, *along_u, *along_v), k);
  }
  asked.divisors = surface.divisors();
  for (const SymbolId letter : letters_of_facts(row, facts)) {
    if (tree.symbols[letter].is_fixed()) continue;
    const Span span = row.claim.relation;
    asked.assumptions.push_back({.left = tree.add({.op = Op::symbol, .span = span, .symbol = letter}),
                                 .right = tree.add_number(span, "0"),
                                 .relation = Relation::unequal});
    asked.not_zero.push_back(letter);
  }
  if (surface.gave_up()) return std::nullopt;
  return asked;
}

/// What proofs of all claims use.
struct Used {
  std::set<std::size_t> facts;
  std::set<SymbolId> not_zero;
};

/// Nothing: a proof was not found.
std::optional<Used> used_in_proof(const RowUnderLaws& row, const Asked& asked) {
  Used used;
  const std::size_t said = asked.facts.size();
  for (const Equation& claim : asked.claims) {
    Question question{.tree = &row.tree, .claim = claim, .assumptions = asked.assumptions};
    const Decision decision = decide(row.cache, question, limits_of_states);
    if (decision.outcome != Outcome::proved) return std::nullopt;
    for (const std::size_t which : decision.assumptions) {
      if (which < said) {
        used.facts.insert(asked.facts[which]);
      } else {
        used.not_zero.insert(asked.not_zero[which - said]);
      }
    }
  }
  return used;
}

bool has_function(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}),
                             [&](ExprId id) { return tree[id].op == Op::function; });
}

/// Neither letters nor Jacobians vanish, nor sides and terms of the claim, but where a 0 is written.
std::vector<Equation> nothing_vanishes(const RowUnderLaws& row, const Asked& asked, const StateFacts& facts) {
  ExprTree& tree = row.tree;
  std::vector<Equation> conditions;
  const auto take = [&](ExprId expr) {
    if (symbols_in(tree, expr).empty() || has_function(tree, expr)) return;
    const Span span = tree[expr].span;
    conditions.push_back({.left = expr, .right = tree.add_number(span, "0"), .relation = Relation::unequal});
  };
  for (const SymbolId letter : facts.letters) {
    if (tree.symbols[letter].is_fixed()) continue;
    take(tree.add({.op = Op::symbol, .span = row.claim.relation, .symbol = letter}));
  }
  for (const ExprId divisor : asked.divisors) take(divisor);
  const Equation& written = row.claim.equation;
  const bool differentials = has_differentials(tree, written);
  for (const Equation& claim : asked.claims) {
    if (differentials || tree.is_zero_literal(written.left) || tree.is_zero_literal(written.right)) continue;
    for (const ExprId side : {claim.left, claim.right}) {
      take(side);
      const std::vector<SignedTerm> terms = signed_terms(tree, side);
      for (const SignedTerm& term : terms) {
        if (terms.size() > 1) take(term.id);
      }
    }
  }
  return conditions;
}

bool is_met(const RowUnderLaws& row, const Asked& asked, const StateFacts& facts) {
  Question question{.tree = &row.tree, .claim = asked.claims.front(), .assumptions = asked.assumptions};
  for (Equation& condition : nothing_vanishes(row, asked, facts))
    question.assumptions.push_back(std::move(condition));
  question.tree = &row.tree;
  return satisfying_sample(row.cache, question, {}, limits_of_witness).has_value();
}

/// `U`, `V` and `T` of `functions of `T` and `V``.
std::string name_of(const RowUnderLaws& row, SymbolId letter) { return row.tree.symbols[letter].name; }

std::vector<std::string> conventions_of(const RowUnderLaws& row, const StateFacts& facts,
                                        const Coordinates& on) {
  std::vector<std::string> conventions{fmt::format("convention: what changes is a function of `{}` and `{}`",
                                                   name_of(row, on.u), name_of(row, on.v))};
  for (const SymbolId letter : facts.letters) {
    const bool known = facts.states.contains(letter) || row.tree.symbols[letter].is_fixed() ||
                       is_declared_constant(row.names.scope, letter);
    if (!known) conventions.push_back(convention_of_constant(row.tree, letter));
  }
  return conventions;
}

std::optional<Judgement> proved_on(const RowUnderLaws& row, const StateFacts& facts, const Coordinates& on) {
  Surface surface(row.tree, on, facts.states);
  const auto asked = asked_on(row, surface, facts);
  const auto used = asked ? used_in_proof(row, *asked) : std::nullopt;
  if (!used) return std::nullopt;
  if (used->facts.size() < facts.facts.size()) return proved_on(row, only(row, facts, used->facts), on);
  if (!is_met(row, *asked, facts)) return std::nullopt;
  Judgement judgement;
  judgement.verdict = Verdict::proved;
  judgement.route = "derivatives on a surface of states";
  judgement.of_another_question = true;
  for (const StateFact& fact : facts.facts) judgement.uses.push_back(fact.name);
  for (const SymbolId letter : used->not_zero)
    judgement.uses.push_back(fmt::format("convention: `{}` is not 0", name_of(row, letter)));
  for (std::string& each : conventions_of(row, facts, on)) judgement.uses.push_back(std::move(each));
  return judgement;
}

}  // namespace

bool speaks_of_states(const ExprTree& tree, const Equation& equation) {
  return has_differentials(tree, equation) || !coordinates_in(tree, equation).empty();
}

bool holds_letters(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  return std::ranges::any_of(
      symbols_reached(tree, scope, {equation.left, equation.right}), [&](SymbolId symbol) {
        const auto& derivation = tree.symbols[symbol].derivation;
        return derivation &&
               std::ranges::any_of(derivation->by, [](const Variable& by) { return by.held.has_value(); });
      });
}

std::optional<Judgement> prove_of_states(const RowUnderLaws& row, const Laws& set) {
  const auto facts = state_facts(row, set);
  if (!facts) return std::nullopt;
  std::vector<Coordinates> all = coordinates_in(row.tree, row.claim.equation);
  for (const StateFact& fact : facts->facts) {
    for (const Coordinates& each : coordinates_in(row.tree, fact.equation)) {
      if (!is_one_of(each, all)) all.push_back(each);
    }
  }
  for (std::size_t k = 0; k < std::min(all.size(), most_coordinates); ++k) {
    if (auto found = proved_on(row, *facts, all[k])) return found;
  }
  return std::nullopt;
}

}  // namespace rigor
