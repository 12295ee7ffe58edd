// SPDX-License-Identifier: GPL-3.0-or-later
// `\sqrt{19} = 4.3`: refuted by bounds of a number that no sample gives exactly.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/doubt/approximate_value.h"
#include "check/doubt/digits.h"
#include "check/place/place.h"
#include "check/question/decision_cache.h"

namespace rigor {
namespace {

/// A slip in a digit, and no equation for the letters.
bool is_near(const ExprTree& tree, const Names& names, const Equation& numbers) {
  constexpr double nearness = 0.2;
  const auto left = approximate_value(tree, names, numbers.left);
  const auto right = approximate_value(tree, names, numbers.right);
  return left && right && std::abs(*left - *right) < nearness * std::abs(*right);
}

/// Where the number lies instead; nothing where the step is not refuted so.
std::optional<Counterexample> bound_of(ExprTree& tree, const Names& names, const Claim& claim,
                                       DecisionCache* cache) {
  if (claim.nearly || claim.doubt != nullptr || claim.equation.relation != Relation::equal)
    return std::nullopt;
  if (guess_of(*claim.reading)) return std::nullopt;
  const auto is_own = [&](ExprId side) {
    return std::ranges::all_of(symbols_in(tree, side),
                               [&](SymbolId symbol) { return is_circle_number(tree, names, symbol); });
  };
  const bool own = is_own(claim.equation.left) && is_own(claim.equation.right);
  const auto compared = agreement_of_digits(tree, names, claim, cache);
  if (!compared || compared->agreement != Agreement::differs || compared->bound.empty() ||
      may_be_rounded_on_the_way(tree, names, claim, *compared))
    return std::nullopt;
  if (!own && !(compared->before_letters && is_near(tree, names, *compared->before_letters)))
    return std::nullopt;
  const Equation shown = compared->before_letters.value_or(claim.equation);
  const auto digits = [&](ExprId side) -> std::optional<std::string> {
    if (tree[side].op != Op::number) return std::nullopt;
    return tree.digits(side);
  };
  if (digits(shown.left) && digits(shown.right)) return std::nullopt;  // nothing is computed
  Counterexample example;
  example.left = digits(shown.left).value_or(compared->bound);
  example.right = digits(shown.right).value_or(compared->bound);
  return example;
}

}  // namespace

void refute_by_digits(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::undecided || judgement.verdict == Verdict::not_understood ||
                    judgement.verdict == Verdict::law;
  if (!open || is_conditional(place) || is_alternative(place, parsed)) return;
  auto example = bound_of(place.tree, place.names, claim, place.options.cache);
  if (!example) return;
  judgement.verdict = Verdict::refuted;
  judgement.route = "by bounds";
  judgement.diagnostics = {{DiagnosticKind::refuted,
                            claim.relation,
                            fmt::format("the sides differ in the digits shown: left is {}, right is {}",
                                        example->left, example->right),
                            {{claim.left, ""}, {claim.right, ""}}}};
  judgement.counterexample = std::move(example);
}

bool replay_by_digits(RowPlace& place, const Claim& claim, Step& step) {
  const Counterexample& recorded = claim.recorded->example;
  const auto is_bound = [](const std::string& text) {
    return text.starts_with("less than ") || text.starts_with("more than ");
  };
  if (!recorded.values.empty() || (!is_bound(recorded.left) && !is_bound(recorded.right))) return false;
  const auto example = bound_of(place.tree, place.names, claim, place.options.cache);
  claim.recorded->replayed = true;
  if (!example || example->left != recorded.left || example->right != recorded.right) {
    claim.recorded->fault = "the sides have other bounds now";
    return true;
  }
  step.verdict = Verdict::refuted;
  step.counterexample = example;
  return true;
}

}  // namespace rigor
