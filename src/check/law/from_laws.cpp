// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/from_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "algebra/words/operator_question.h"
#include "check/law/bearing.h"
#include "check/law/from_set.h"
#include "check/law/restated.h"
#include "check/law/solves.h"
#include "check/law/states.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"

namespace rigor {
namespace {

constexpr std::uint64_t most_work = 250'000;  // on all sets together, of the work that a step may take
constexpr std::uint64_t most_work_of_trials = 1'000'000;  // few rows stand below one
constexpr std::uint64_t most_work_of_states = 1'500'000;  // where derivatives hold letters by name

/// The row says again what a law says.
std::optional<Judgement> restating(const RowUnderLaws& row, const Laws& bearing) {
  const std::set<SymbolId> own = written_letters(row.tree, row.claim.equation);
  std::optional<Sample> fails;
  for (const PageLaw* law : bearing) {
    if (written_letters(row.tree, law->equation) != own) continue;
    if (!fails) fails = where_it_fails(row.tree, row.claim.equation, row.cache);
    if (!fails) return std::nullopt;
    if (!restates(row.tree, row.claim.equation, *fails, law->equation, row.cache)) continue;
    Judgement judgement;
    judgement.verdict = Verdict::law;
    judgement.restates = true;
    judgement.route = fmt::format("restates {}", law->name);
    judgement.uses = {law->name};
    return judgement;
  }
  return std::nullopt;
}

/// The sets that may prove the row, the smallest first, each with what is beside all of them. What fails at
/// points that meet a set follows from no part of it, so the largest set is looked at first.
std::vector<Laws> promising_sets(const RowUnderLaws& row, const Laws& bearing, const Laws& beside) {
  std::vector<Laws> sets = sets_of(row.tree, bearing);
  for (Laws& set : sets) set.insert(set.end(), beside.begin(), beside.end());
  while (sets.size() > 1 && fails_under(row, sets.back())) {
    const Laws failing = sets.back();
    std::erase_if(sets, [&](const Laws& set) {
      return std::ranges::all_of(set,
                                 [&](const PageLaw* law) { return std::ranges::count(failing, law) > 0; });
    });
    if (sets.empty()) break;
  }
  return sets;
}

/// `f/m`: letters and numbers, and nothing else.
bool is_of_letters(const ExprTree& tree, ExprId id, std::vector<SymbolId>& letters) {
  const ExprNode& node = tree[id];
  if (node.op == Op::number) return true;
  if (node.op == Op::symbol) letters.push_back(node.symbol);
  if (node.op == Op::symbol) return node.rank == 0 && node.slot_count == 0;
  return (node.op == Op::multiply || node.op == Op::divide) &&
         std::ranges::all_of(tree.children(id),
                             [&](ExprId child) { return is_of_letters(tree, child, letters); });
}

/// `\sqrt{2gh}`, `2\pi\sqrt{l/g}`: never negative; nor `f/\sqrt{a^2 + b^2}`, where f is not. `letters`: such
/// as f.
bool is_written_root(const ExprTree& tree, ExprId id, std::vector<SymbolId>& letters) {
  const ExprNode& node = tree[id];
  if (node.op == Op::root) return true;
  if (node.op != Op::multiply && node.op != Op::divide) return false;
  bool root = false;
  for (const ExprId child : tree.children(id)) {
    const ExprNode& factor = tree[child];
    const bool letter = factor.op == Op::symbol && factor.rank == 0 && factor.slot_count == 0;
    const bool circle = letter && tree.symbols[factor.symbol].circle_number;
    if (factor.op == Op::number || circle) continue;
    if (letter && !tree.symbols[factor.symbol].derivation) {
      letters.push_back(factor.symbol);
      continue;
    }
    const bool quotient = node.op == Op::divide && factor.op == Op::divide;  // `(f/m)/\sqrt{…}`
    const bool one = is_written_root(tree, child, letters);
    if (!one && !(quotient && is_of_letters(tree, child, letters))) return false;
    root = root || one;
  }
  return root;
}

/// The square of such a product, without its roots: a sample seldom has them.
ExprId squared(ExprTree& tree, ExprId id) {
  const ExprNode node = tree[id];
  if (node.op == Op::root) return tree.children(id)[0];
  if (node.op != Op::multiply && node.op != Op::divide)
    return tree.add({.op = Op::power, .span = node.span, .exponent = 2}, std::span(&id, 1));
  std::vector<ExprId> factors(tree.children(id).begin(), tree.children(id).end());
  for (ExprId& factor : factors) factor = squared(tree, factor);
  return tree.add({.op = node.op, .span = node.span}, factors);
}

/// `u = \sqrt{2gh}` of `u^2/2 = gh`: the squares follow, and the root is the one that is not negative.
/// `of_trial`: of what a trial function asks.
std::optional<Judgement> takes_a_root(const RowUnderLaws& row, const Laws& bearing, bool of_trial) {
  const Equation& own = row.claim.equation;
  const ExprNode left = row.tree[own.left];
  const bool letter = left.op == Op::symbol && left.rank == 0 && left.slot_count == 0 &&
                      !row.tree.symbols[left.symbol].derivation &&
                      definition_of(row.names.scope, left.symbol) == nullptr;
  std::vector<SymbolId> positive{left.symbol};
  if (own.relation != Relation::equal || !letter || !is_written_root(row.tree, own.right, positive))
    return std::nullopt;
  const auto is_it = [&](ExprId side) {
    return row.tree[side].op == Op::symbol && row.tree[side].symbol == left.symbol;
  };
  const bool is_said = std::ranges::any_of(
      bearing, [&](const PageLaw* law) { return is_it(law->equation.left) || is_it(law->equation.right); });
  if (is_said) return std::nullopt;  // it may be the other root
  Claim squares = row.claim;
  squares.equation.left = squared(row.tree, own.left);
  squares.equation.right = squared(row.tree, own.right);
  const RowUnderLaws of_squares{row.tree, row.names, squares, row.cache};
  const ExprId zero = row.tree.add_number(left.span, "0");
  const auto with_signs = [&](std::optional<Judgement> found, const Laws& set) -> std::optional<Judgement> {
    if (!found) return std::nullopt;
    Names signs = with_laws(row.tree, row.names, set);  // none of which may say that it is negative
    for (const SymbolId each : positive) {
      const std::string says = fmt::format("convention: `{}` is not negative, since a root is written for it",
                                           row.tree.symbols[each].name);
      const ExprId symbol = row.tree.add({.op = Op::symbol, .span = left.span, .symbol = each});
      assume(
          signs.scope,
          {{.left = zero, .right = symbol, .relation = Relation::less}, Origin{says, {}, std::nullopt}, 0});
      found->uses.push_back(says);
    }
    if (!sample_of_assumptions(row.tree, signs, {}, {}, row.cache)) return std::nullopt;
    return found;
  };
  if (of_trial) return with_signs(follows_from_trial(of_squares, bearing), {});
  for (const Laws& set : sets_of(row.tree, bearing)) {
    if (set.empty()) continue;
    if (auto found = with_signs(prove_from(of_squares, set), set)) return found;
  }
  return std::nullopt;
}

/// What is beside every set, taken out of the laws: conventions, and what a letter of the row is said to be.
Laws taken_from_sets(const RowUnderLaws& row, Laws& laws) {
  const std::set<SymbolId> own = written_letters(row.tree, row.claim.equation);
  const auto taken = std::ranges::stable_partition(laws, [&](const PageLaw* law) {
    return !law->by_convention && !(law->names_a_letter && own.contains(row.tree[law->equation.left].symbol));
  });
  Laws beside(taken.begin(), taken.end());
  laws.erase(taken.begin(), taken.end());
  return beside;
}

std::optional<Judgement> follow(const RowUnderLaws& row, const AvailableLaws& available, bool inferred) {
  if (auto found = prove_from(row, {})) return found;
  Laws bearing = laws_that_bear(row.tree, row.names.scope, row.claim.equation, available.all);
  if (auto restated = inferred ? std::nullopt : restating(row, bearing)) return restated;
  const Laws beside = taken_from_sets(row, bearing);
  if (auto solved = solves(row, bearing, available.all)) return solved;
  if (holds_letters(row.tree, row.names.scope, row.claim.equation)) {
    for (const Laws& set : sets_of_states(bearing)) {
      if (auto found = prove_from(row, set)) return found;
    }
  }
  if (!available.named.empty()) {
    Laws named = available.named;
    named.insert(named.end(), beside.begin(), beside.end());
    if (auto found = prove_from(row, named)) return found;
  }
  for (const Laws& set : promising_sets(row, bearing, beside)) {
    if (set.empty()) continue;  // tried
    if (auto found = prove_from(row, set)) return found;
  }
  bearing.insert(bearing.end(), beside.begin(), beside.end());
  return takes_a_root(row, bearing, false);
}

}  // namespace

std::optional<Judgement> follow_from_laws(ExprTree& tree, const Names& names, const Claim& claim,
                                          const AvailableLaws& available, bool inferred,
                                          DecisionCache& cache) {
  if (claim.nearly || claim.for_all || claim.recorded != nullptr) return std::nullopt;
  if (cache.budget().exhausted()) return std::nullopt;
  const bool of_states =
      speaks_of_states(tree, claim.equation) || holds_letters(tree, names.scope, claim.equation);
  const RowUnderLaws row{tree, names, claim, &cache};
  {
    const ShareOfWork share(cache, of_states ? most_work_of_states : most_work);
    if (auto found = follow(row, available, inferred)) return found;
  }
  const ShareOfWork share(cache, most_work_of_trials);
  const Laws bearing = laws_that_bear(tree, names.scope, claim.equation, available.all);
  if (auto found = takes_a_root(row, bearing, true)) return found;
  return follows_from_trial(row, bearing);
}

bool is_denied_by_laws(ExprTree& tree, const Names& names, const Claim& claim, const Laws& available,
                       DecisionCache& cache) {
  const bool operators =
      has_operators(tree, claim.equation.left) || has_operators(tree, claim.equation.right);
  if (claim.nearly || !operators || cache.budget().exhausted()) return false;
  const ShareOfWork share(cache, most_work);
  const Laws bearing = laws_that_bear(tree, names.scope, claim.equation, available);
  const std::vector<Laws> sets = sets_of(tree, bearing);
  return std::ranges::any_of(sets, [&](const Laws& set) {
    const Prepared prepared = prepare(tree, with_laws(tree, names, set), claim.equation);
    Limits limits;
    limits.budget = &cache.budget();
    return !prepared.too_large && operators_deny(prepared.question, limits);
  });
}

}  // namespace rigor
