// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/two_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "base/among.h"
#include "check/average/average_value.h"
#include "check/question/decision_cache.h"
#include "expr/calculus/differentiate.h"
#include "expr/calculus/integrate.h"

namespace rigor {
namespace {

/// Factors of averages, with their exponents.
using ProductOfAverages = std::map<SymbolId, int>;

ExprId with_values(ExprTree& tree, const Question& question, ExprId side) {
  return replaced(tree, side, [&](ExprId id) -> std::optional<ExprId> {
    const Definition* definition = definition_in(question, tree[id].symbol);
    const bool plain = definition != nullptr && definition->indices.empty() && !definition->by_square &&
                       definition->particle == no_particle && tree[id].slot_count == 0;
    return plain ? std::optional(definition->body) : std::nullopt;
  });
}

/// Nothing where a side is no sum of such products.
std::optional<std::set<ProductOfAverages>> products_of_averages(ExprTree& tree, const Question& question,
                                                                ExprId side) {
  constexpr int deepest = 8;  // definitions of definitions
  for (int k = 0; k < deepest; ++k) {
    const ExprId next = with_values(tree, question, side);
    if (next == side) break;
    side = next;
  }
  const std::vector<SymbolId> averages = averages_of(question);
  if (tree[side].rank != 0 || averages.empty()) return std::nullopt;
  const Running running{
      .variable = tree.symbols[base_of(tree.symbols, averages[0])].integral->variable,  // is in no side
      .changes = [&tree](SymbolId symbol) { return is_average(tree, symbol); },
      .antiderivative = {}};
  const auto terms = integrand_terms(tree, side, running);
  if (!terms) return std::nullopt;
  std::set<ProductOfAverages> products;
  for (const IntegrandTerm& term : *terms) {
    ProductOfAverages product;
    for (const ExprId factor : term.running) {
      const bool power = tree[factor].op == Op::power;
      const ExprId base = power ? tree.children(factor)[0] : factor;
      if (tree[base].op != Op::symbol) return std::nullopt;
      product[tree[base].symbol] += power ? tree[factor].exponent : 1;
    }
    products.insert(std::move(product));
  }
  return products;
}

/// The averages as those of two outcomes.
class OutcomesAsDefinitions {
 public:
  OutcomesAsDefinitions(ExprTree& tree, const Names& names) : tree_(tree), names_(names) {}

  /// False where it says nothing, or too little is known of its letters.
  bool add(SymbolId average, Question& question) {
    const Symbol& known = tree_.symbols[average];
    if (!known.integral || !known.integral->average) return false;  // a derivative
    const ExprId inside = known.integral->integrand;
    const Span span = known.first_seen;
    const auto first = at_outcome(inside, 0);
    const auto second = at_outcome(inside, 1);
    if (!first || !second) return false;
    const std::array both{*first, *second};
    const std::array half{tree_.add({.op = Op::add, .span = span}, both), tree_.add_number(span, "2")};
    question.definitions.push_back(
        {average, {}, no_particle, tree_.add({.op = Op::divide, .span = span}, half)});
    return true;
  }

  /// The outcomes of a letter differ.
  void add_differences(Question& question) {
    for (const auto& [symbol, at] : outcomes_) {
      const Span span = tree_.symbols[symbol].first_seen;
      const auto node = [&](SymbolId each) {
        return tree_.add({.op = Op::symbol, .span = span, .symbol = each});
      };
      question.assumptions.push_back({.left = node(at[0]),
                                      .right = node(at[1]),
                                      .indices = {},
                                      .particles = {},
                                      .relation = Relation::unequal});
    }
  }

  /// "`x` is 0 or 1, and `y` 2 or 3"
  [[nodiscard]] std::string described(const Sample& sample) const {
    std::string text;
    const auto value = [&](SymbolId symbol) {
      const auto found = std::ranges::find(sample.values, symbol, &SampleValue::symbol);
      return found == sample.values.end() || found->components.empty() ? "0" : found->components[0];
    };
    for (const auto& [symbol, at] : outcomes_)
      text += fmt::format("{}`{}` is {} or {}", text.empty() ? "" : ", and ", tree_.symbols[symbol].name,
                          value(at[0]), value(at[1]));
    return text;
  }

 private:
  std::optional<ExprId> at_outcome(ExprId inside, std::size_t which) {
    bool plain = true;
    const ExprId result = replaced(tree_, inside, [&](ExprId id) -> std::optional<ExprId> {
      const SymbolId symbol = tree_[id].symbol;
      if (!may_fluctuate(tree_, names_, symbol)) return std::nullopt;
      const Symbol& known = tree_.symbols[symbol];
      const bool letter = known.rank == 0 && !known.derivation && !known.integral && !known.per_particle &&
                          tree_[id].slot_count == 0;
      plain = plain && letter && (fluctuates_surely(tree_, names_, symbol) || known.noncommuting);
      if (!plain) return std::nullopt;
      if (known.noncommuting) operators_.insert(symbol);
      plain = operators_.size() < 2;  // two need not commute
      return tree_.add({.op = Op::symbol, .span = tree_[id].span, .symbol = outcome(symbol, which)});
    });
    return plain ? std::optional(result) : std::nullopt;
  }

  SymbolId outcome(SymbolId symbol, std::size_t which) {
    auto known = outcomes_.find(symbol);
    if (known == outcomes_.end()) {
      Symbol fresh{.name = tree_.symbols[symbol].name, .complex = tree_.symbols[symbol].complex};
      const SymbolId first = tree_.symbols.add(fresh);
      const SymbolId second = tree_.symbols.add(std::move(fresh));
      known = outcomes_.emplace(symbol, std::array{first, second}).first;
    }
    return known->second[which];
  }

  ExprTree& tree_;
  const Names& names_;
  std::map<SymbolId, std::array<SymbolId, 2>> outcomes_;
  std::set<SymbolId> operators_;
};

}  // namespace

std::vector<SymbolId> averages_of(const Question& question) {
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
  std::vector<SymbolId> found = symbols_reached(*question.tree, roots, [&](SymbolId symbol) {
    const Definition* definition = definition_in(question, symbol);
    return definition == nullptr ? std::nullopt : std::optional(definition->body);
  });
  std::erase_if(found, [&](SymbolId symbol) {
    return !is_average(*question.tree, symbol) || definition_in(question, symbol) != nullptr;
  });
  return found;
}

bool speaks_of_averages(ExprTree& tree, Prepared& prepared) {
  prepared.question.tree = &tree;
  return prepared.open_average && !averages_of(prepared.question).empty();
}

bool relates_different_averages(ExprTree& tree, Prepared& prepared, DecisionCache* cache) {
  if (!speaks_of_averages(tree, prepared) || prepared.question.claim.relation != Relation::equal)
    return false;
  Question opposite = prepared.question;
  const auto left = products_of_averages(tree, opposite, opposite.claim.left);
  const auto right = products_of_averages(tree, opposite, opposite.claim.right);
  const auto has_any = [](const std::set<ProductOfAverages>& products) {
    return std::ranges::any_of(products, [](const ProductOfAverages& each) { return !each.empty(); });
  };
  if (!left || !right || *left != *right || !has_any(*left)) return true;
  const ExprId side = opposite.claim.right;
  opposite.claim.right = tree.add({.op = Op::negate, .span = tree[side].span}, std::span(&side, 1));
  return decide(cache, opposite, {.simplest_sample = false}).outcome == Outcome::proved;
}

std::optional<TwoOutcomes> refuted_by_two_outcomes(ExprTree& tree, const Names& names,
                                                   const Prepared& prepared, const Limits& limits,
                                                   DecisionCache* cache) {
  if (prepared.has_laws_of_operators) return std::nullopt;
  Question question = prepared.question;
  question.tree = &tree;
  OutcomesAsDefinitions outcomes(tree, names);
  for (const SymbolId average : averages_of(question)) {
    if (!outcomes.add(average, question)) return std::nullopt;
  }
  outcomes.add_differences(question);
  Decision decision = decide(cache, question, limits);
  if (decision.outcome != Outcome::refuted) return std::nullopt;
  Sample sample = *decision.sample;
  const std::vector<SampleValue> follow = following_values(question, sample);
  sample.values.insert(sample.values.end(), follow.begin(), follow.end());
  Question asked = prepared.question;
  asked.tree = &tree;
  const std::vector<SymbolId> wanted = symbols_of_sample(asked);
  std::erase_if(sample.values, [&](const SampleValue& each) { return !is_one_of(each.symbol, wanted); });
  const Replay again = replay_closely(asked, sample);
  if (again.fault != Replay::Fault::none || !again.differ) return std::nullopt;
  sample.left = again.sides.left;
  sample.right = again.sides.right;
  return TwoOutcomes{std::move(sample), outcomes.described(*decision.sample)};
}

}  // namespace rigor
