// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/from_laws.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "algebra/words/operator_question.h"
#include "check/law/bearing.h"
#include "check/law/from_set.h"
#include "check/law/restated.h"
#include "check/law/solves.h"
#include "check/law/states.h"
#include "check/meaning/identity_reading.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

constexpr std::uint64_t most_work = 250'000;  // on all sets together, of the work that a step may take
constexpr Limits limits_of_squares{
    .expanded_terms = 20'000, .steps = 50'000, .sample_attempts = 1, .simplest_sample = false};
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

/// A product of letters, numbers and written roots: `2\pi r/v`, `A\sqrt{k/m}`.
struct SignedProduct {
  std::map<std::string, ExprId> odd = {};  // the letters and components that decide its sign, as printed
  bool has_root = false;
};

/// Even powers do not count.
void multiply_signs(std::map<std::string, ExprId>& signs, const std::map<std::string, ExprId>& by) {
  for (const auto& entry : by) {
    if (!signs.insert(entry).second) signs.erase(entry.first);
  }
}

/// Definitions are put in. Nothing: it is something else.
std::optional<SignedProduct> as_signed_product(const ExprTree& tree, const NameScope& scope, ExprId id,
                                               int deepest = 8) {
  const ExprNode& node = tree[id];
  if (node.op == Op::number) return SignedProduct{};
  if (node.op == Op::root) return SignedProduct{.has_root = true};
  if (node.op == Op::symbol) {
    const Symbol& symbol = tree.symbols[node.symbol];
    if (symbol.circle_number) return SignedProduct{};
    if (node.rank > 0 || symbol.derivation || symbol.noncommuting || deepest == 0) return std::nullopt;
    if (const auto body = body_of_definition(scope, node.symbol); body && node.slot_count == 0)
      return as_signed_product(tree, scope, *body, deepest - 1);
    return SignedProduct{.odd = {{print_latex(tree, id), id}}};
  }
  const bool even = node.op == Op::power && node.exponent % 2 == 0;
  if (node.op != Op::multiply && node.op != Op::divide && node.op != Op::power) return std::nullopt;
  SignedProduct product;
  for (const ExprId child : tree.children(id)) {
    const auto factor = as_signed_product(tree, scope, child, deepest);
    if (!factor) return std::nullopt;
    product.has_root = product.has_root || factor->has_root;
    multiply_signs(product.odd, factor->odd);
  }
  if (even) product.odd.clear();
  return product;
}

/// The letters that a row with a written root takes for positive: v of `v = \sqrt{2gh}`, and A with it of
/// `v = A\sqrt{k/m}`. None may be said to be something but a root or a product: that may be the other root.
std::map<std::string, ExprId> positive_beside_a_root(const RowUnderLaws& row, const Laws& bearing) {
  const Equation& own = row.claim.equation;
  const auto left = as_signed_product(row.tree, row.names.scope, own.left);
  const auto right = as_signed_product(row.tree, row.names.scope, own.right);
  if (own.relation != Relation::equal || !left || !right || left->has_root == right->has_root) return {};
  std::map<std::string, ExprId> letters = left->odd;
  multiply_signs(letters, right->odd);
  const auto is_said = [&](const auto& letter) {
    const auto is_it = [&](ExprId side, ExprId other) {
      if (row.tree[side].op != Op::symbol || print_latex(row.tree, side) != letter.first) return false;
      return !as_signed_product(row.tree, row.names.scope, other);
    };
    return std::ranges::any_of(bearing, [&](const PageLaw* law) {
      return is_it(law->equation.left, law->equation.right) || is_it(law->equation.right, law->equation.left);
    });
  };
  return std::ranges::any_of(letters, is_said) ? std::map<std::string, ExprId>{} : letters;
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

/// `a + b = 0`, `pR = -qr`: of two products of letters one is negative.
bool says_opposite_signs(const ExprTree& tree, const Equation& law) {
  std::vector<SignedTerm> terms = signed_terms(tree, law.left);
  for (SignedTerm term : signed_terms(tree, law.right)) {
    if (tree.is_zero_literal(term.id)) continue;
    term.negative = !term.negative;
    terms.push_back(term);
  }
  std::erase_if(terms, [&](const SignedTerm& term) { return tree.is_zero_literal(term.id); });
  const auto is_rate = [&](SymbolId each) { return tree.symbols[each].derivation.has_value(); };
  return terms.size() == 2 && terms[0].negative == terms[1].negative &&
         std::ranges::none_of(symbols_in(tree, law.left), is_rate) &&
         std::ranges::none_of(symbols_in(tree, law.right), is_rate);
}

/// `u = \sqrt{2gh}` of `u^2/2 = gh`: the squares follow, and the root is the one that is not negative.
/// `of_trial`: of what a trial function asks.
std::optional<Judgement> takes_a_root(const RowUnderLaws& row, const Laws& bearing, bool of_trial) {
  const std::map<std::string, ExprId> letters = positive_beside_a_root(row, bearing);
  const bool alone = letters.size() == 1 && row.tree[row.claim.equation.left].op == Op::symbol;
  if (letters.empty() || (!alone && row.names.symbols.evidence->speaks_of_signs)) return std::nullopt;
  const auto is_signed = [&](const PageLaw* law) { return says_opposite_signs(row.tree, law->equation); };
  if (!alone && std::ranges::any_of(bearing, is_signed)) return std::nullopt;
  Claim squares = row.claim;
  squares.equation.left = squared(row.tree, row.claim.equation.left);
  squares.equation.right = squared(row.tree, row.claim.equation.right);
  const RowUnderLaws of_squares{row.tree, row.names, squares, row.cache};
  std::vector<std::string> names;
  for (const auto& [name, letter] : letters) names.push_back(fmt::format("`{}`", name));
  const std::string says =
      fmt::format("convention: {} {} not negative, since a root is written for {}", fmt::join(names, " and "),
                  names.size() == 1 ? "is" : "are", names.size() == 1 ? "it" : "them");
  const ExprId zero = row.tree.add_number(row.claim.relation, "0");
  const auto with_signs = [&](std::optional<Judgement> found, const Laws& set) -> std::optional<Judgement> {
    if (!found || found->verdict != Verdict::proved || found->uses.empty()) return std::nullopt;
    Names positive = with_laws(row.tree, row.names, set);  // none of which may say that one is negative
    for (const auto& [name, letter] : letters)
      assume(
          positive.scope,
          {{.left = zero, .right = letter, .relation = Relation::less}, Origin{says, {}, std::nullopt}, 0});
    if (!sample_of_assumptions(row.tree, positive, {}, {}, row.cache)) return std::nullopt;
    found->uses.push_back(says);
    return found;
  };
  if (of_trial) return with_signs(follows_from_trial(of_squares, bearing), {});
  for (const Laws& set : sets_of(row.tree, bearing)) {
    auto found = set.empty()
                     ? std::optional(judge(row.tree, row.names, squares, limits_of_squares, row.cache))
                     : prove_from(of_squares, set);
    if (auto proved = with_signs(std::move(found), set)) return proved;
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
