// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/sign_doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

namespace rigor {
namespace {

/// The first number of a sample, not meant for all values, whose value is of some kind.
template <class Kind>
[[nodiscard]] const Symbol* not_for_all(const ExprTree& tree, const NameScope& scope, const Sample& sample,
                                        const Kind& is_of_kind) {
  const auto found = std::ranges::find_if(sample.values, [&](const SampleValue& value) {
    return tree.symbols[value.symbol].rank == 0 && !is_for_all(scope, value.symbol) &&
           is_of_kind(value.components[0]);
  });
  return found == sample.values.end() ? nullptr : &tree.symbols[found->symbol];
}

[[nodiscard]] bool has_equal_squares(ExprTree& tree, Question question, DecisionCache* cache) {
  if (question.claim.relation != Relation::equal || tree[question.claim.left].rank != 0) return false;
  for (ExprId* side : {&question.claim.left, &question.claim.right}) {
    const ExprId base = *side;
    *side =
        tree.add({.op = Op::power, .span = tree[base].span, .exponent = 2}, std::span(&base, std::size_t{1}));
  }
  question.tree = &tree;
  return decide(cache, question, {.simplest_sample = false}).outcome == Outcome::proved;
}

}  // namespace

bool asks_for_real_numbers(const ExprTree& tree, const Question& question) {
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Definition& definition : question.definitions) roots.push_back(definition.body);
  return std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    const Op op = tree[id].op;
    return op == Op::root || op == Op::length || op == Op::absolute;
  });
}

namespace {

/// `\arctan x = \pi/2 - \arctan(1/x)` holds for lengths and masses.
bool has_inverse_function(const ExprTree& tree, const Question& question) {
  return std::ranges::any_of(nodes_below(tree, {question.claim.left, question.claim.right}), [&](ExprId id) {
    const Function function = tree[id].function;
    return tree[id].op == Op::function &&
           (function == Function::arctan || function == Function::arcsin || function == Function::arccos);
  });
}

std::string for_all(const std::string& name) {
  return fmt::format("if all values are meant, `rigor: for all {}` says so", name);
}

}  // namespace

std::optional<SignDoubt> doubt_of_signs(ExprTree& tree, const Question& question, const NameScope& scope,
                                        const Sample& sample, DecisionCache* cache) {
  if (!asks_for_real_numbers(tree, question) && !has_inverse_function(tree, question)) return std::nullopt;
  // samples prefer positive scalars, so that a negative one was needed
  const Symbol* negative =
      not_for_all(tree, scope, sample, [](const std::string& value) { return value.starts_with('-'); });
  if (negative != nullptr) {
    return SignDoubt{
        negative->name,
        fmt::format("it was found to fail only where `{}` is negative, and nothing says whether it can be",
                    negative->name),
        {fmt::format("`rigor: given {} > 0` says that it cannot", negative->name), for_all(negative->name)}};
  }
  const Symbol* angle = not_for_all(tree, scope, sample, [](const std::string& value) {
    return value.find("arctan") != std::string::npos;
  });
  if (angle == nullptr || !has_equal_squares(tree, question, cache)) return std::nullopt;
  return SignDoubt{angle->name,
                   fmt::format("the squares of both sides are equal, so only a sign is wrong, "
                               "and nothing says which values of `{}` are meant",
                               angle->name),
                   {for_all(angle->name)}};
}

}  // namespace rigor
