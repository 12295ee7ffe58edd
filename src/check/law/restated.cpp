// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/restated.h"

#include <algorithm>
#include <array>
#include <utility>

#include "check/question/decision_cache.h"
#include "check/verdict/rational_expression.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

ExprId difference(ExprTree& tree, ExprId left, ExprId right) {
  const ExprNode node = tree[left];
  const std::array negated{right};
  const std::array terms{left, tree.add({.op = Op::negate, .rank = node.rank, .span = node.span}, negated)};
  return tree.add({.op = Op::add, .rank = node.rank, .span = node.span}, terms);
}

ExprId product(ExprTree& tree, ExprId number, ExprId value) {
  const std::array factors{number, value};
  const ExprNode node = tree[value];
  return tree.add({.op = Op::multiply, .rank = node.rank, .span = node.span}, factors);
}

}  // namespace

bool restates(ExprTree& tree, const Equation& claim, const Equation& law, DecisionCache* cache) {
  const bool repeats =
      !claim.indices.empty() || !claim.particles.empty() || !law.indices.empty() || !law.particles.empty();
  if (repeats || claim.relation != Relation::equal || law.relation != Relation::equal) return false;
  if (tree[claim.left].rank != tree[law.left].rank) return false;
  Question question{.tree = &tree, .claim = claim};
  const Decision decision = decide(cache, question, {.simplest_sample = false});
  if (decision.outcome != Outcome::refuted) return false;
  const Sample& sample = *decision.sample;
  question.claim = law;
  const auto sides = replay(question, sample);
  if (!sides) return false;
  const Span span = tree[claim.left].span;
  const auto number = [&](const std::string& left, const std::string& right) -> std::optional<ExprId> {
    const auto first = add_rational(tree, span, left);
    const auto second = add_rational(tree, span, right);
    return first && second ? std::optional(difference(tree, *first, *second)) : std::nullopt;
  };
  const auto of_law = number(sides->left, sides->right);
  const auto of_claim = number(sample.left, sample.right);
  if (!of_law || !of_claim) return false;
  const auto is_same = [&](ExprId own, ExprId other) {
    question.claim.left = product(tree, *of_law, own);
    question.claim.right = product(tree, *of_claim, other);
    const Decision same = decide(cache, question, {.simplest_sample = false});
    return same.outcome == Outcome::proved && !same.vanishes;
  };
  if (!is_same(difference(tree, claim.left, claim.right), difference(tree, law.left, law.right)))
    return false;
  const ExprId zero = zero_of_rank(tree, span, tree[law.right].rank, tree[law.right].axes);
  const std::array kept{std::pair(claim.left, law.left), std::pair(claim.right, law.right)};
  const std::array exchanged{std::pair(claim.right, difference(tree, zero, law.left)),
                             std::pair(claim.left, difference(tree, zero, law.right))};
  // One side is enough; a side that is 0 shows nothing.
  const auto is_same_side = [&](const auto& sides_of_both) {
    return is_same(sides_of_both.first, sides_of_both.second);
  };
  return std::ranges::any_of(kept, is_same_side) || std::ranges::any_of(exchanged, is_same_side);
}

}  // namespace rigor
