// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/restated.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "algebra/decide/decide.h"
#include "base/small_rational.h"
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

/// `-3/2`; not valid where it is no rational number that fits.
SmallRational small_rational(const std::string& text) {
  const auto whole = [](std::string_view digits) -> std::optional<std::int64_t> {
    std::int64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
  };
  const std::string_view view = text;
  const std::size_t slash = view.find('/');
  const auto over = whole(view.substr(0, slash));
  const auto under =
      slash == std::string_view::npos ? std::optional<std::int64_t>(1) : whole(view.substr(slash + 1));
  return over && under ? SmallRational(*over, *under) : SmallRational(1, 0);
}

/// Do the sides' numbers where the claim fails show that the law's are no multiples of its own? Most laws
/// with the same letters end here, which saves them a proof.
bool are_no_multiples(const Sample& claim, const SideValues& law) {
  const SmallRational left = small_rational(claim.left);
  const SmallRational right = small_rational(claim.right);
  const SmallRational law_left = small_rational(law.left);
  const SmallRational law_right = small_rational(law.right);
  const SmallRational of_claim = left + right * SmallRational(-1);
  const SmallRational of_law = law_left + law_right * SmallRational(-1);
  if (!of_claim.is_valid() || !of_law.is_valid()) return false;  // who knows
  if (of_law.is_zero()) return true;
  const auto may_agree = [&](const SmallRational& own, const SmallRational& other) {
    const SmallRational rest = own * of_law + other * of_claim * SmallRational(-1);
    return !rest.is_valid() || rest.is_zero();
  };
  const SmallRational minus(-1);
  return !may_agree(left, law_left) && !may_agree(right, law_right) && !may_agree(right, law_left * minus) &&
         !may_agree(left, law_right * minus);
}

bool repeats_or_compares(const Equation& equation) {
  return !equation.indices.empty() || !equation.particles.empty() || equation.relation != Relation::equal;
}

}  // namespace

std::optional<Sample> where_it_fails(const ExprTree& tree, const Equation& claim, DecisionCache* cache) {
  if (repeats_or_compares(claim)) return std::nullopt;
  Decision decision = decide(cache, {.tree = &tree, .claim = claim}, {.simplest_sample = false});
  if (decision.outcome != Outcome::refuted) return std::nullopt;
  return std::move(decision.sample);
}

bool restates(ExprTree& tree, const Equation& claim, const Sample& fails, const Equation& law,
              DecisionCache* cache) {
  if (repeats_or_compares(law)) return false;
  if (tree[claim.left].rank != tree[law.left].rank) return false;
  Question question{.tree = &tree, .claim = law};
  const auto sides = replay(question, fails);
  if (!sides || are_no_multiples(fails, *sides)) return false;
  const Span span = tree[claim.left].span;
  const auto number = [&](const std::string& left, const std::string& right) -> std::optional<ExprId> {
    const auto first = add_rational(tree, span, left);
    const auto second = add_rational(tree, span, right);
    return first && second ? std::optional(difference(tree, *first, *second)) : std::nullopt;
  };
  const auto of_law = number(sides->left, sides->right);
  const auto of_claim = number(fails.left, fails.right);
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
