// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/witness.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "algebra/rough/rough_screen.h"
#include "check/meaning/identity_reading.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

class NonZero {
 public:
  explicit NonZero(ExprTree& tree) : tree_(tree) {}

  void add(const Equation& equation) {
    for (const ExprId side : {equation.left, equation.right}) {
      const ExprId other = side == equation.left ? equation.right : equation.left;
      const bool vanishes = tree_.is_zero_literal(other);
      if (vanishes && tree_[side].op == Op::symbol) zero_.insert(tree_[side].symbol);
      add_letters(side);
      add_angles(side);
      const bool repeats = !equation.indices.empty() || !equation.particles.empty();
      if (repeats || tree_.is_zero_literal(side)) continue;
      const std::vector<ExprId> terms = written_terms(side);
      if (!vanishes && !has_function(side)) sides_.insert(side);
      if (terms.size() == 1) continue;
      std::vector<ExprId>& own = vanishes ? vanishing_.emplace_back() : terms_;
      for (const ExprId term : terms) {
        if (!has_function(term)) own.push_back(term);
      }
    }
  }

  /// The terms beside others, of sums that are not set equal to 0.
  [[nodiscard]] const std::vector<ExprId>& terms() const { return terms_; }
  void let_vanish(ExprId term) { std::erase(terms_, term); }

  /// As assumptions.
  [[nodiscard]] std::vector<Equation> conditions(const std::vector<SymbolId>& zeroed) {
    std::set<SymbolId> zeros(zeroed.begin(), zeroed.end());
    zeros.insert(zero_.begin(), zero_.end());
    std::vector<Equation> conditions;
    const auto take = [&](ExprId expr) {
      if (auto condition = is_not_zero(expr)) conditions.push_back(*std::move(condition));
    };
    std::set<SymbolId> letters = letters_;
    std::ranges::set_difference(differentiated_, inside_, std::inserter(letters, letters.end()));
    for (const SymbolId letter : letters) {
      const Symbol symbol = tree_.symbols[letter];
      if (symbol.per_particle || symbol.rank > 1 || symbol.rotation || symbol.unit_of_measure) continue;
      if (zeros.contains(letter)) continue;
      take(tree_.add({.op = Op::symbol, .rank = static_cast<std::uint8_t>(symbol.rank), .symbol = letter}));
    }
    for (const ExprId side : sides_) take(side);
    for (const ExprId angle : angles_) take(angle);
    const auto without_zeros = [&](std::vector<ExprId> terms) {
      std::erase_if(terms, [&](ExprId term) { return has_factor(term, zeros); });
      return terms;
    };
    for (const ExprId term : without_zeros(terms_)) take(term);
    for (const std::vector<ExprId>& sum : vanishing_) {
      const std::vector<ExprId> left = without_zeros(sum);
      if (left.size() < 2) continue;  // one term alone is the 0 that is written
      for (const ExprId term : left) take(term);
    }
    return conditions;
  }

 private:
  /// The terms of a sum as they are written: what a product under a derivative multiplies out to is one.
  [[nodiscard]] std::vector<ExprId> written_terms(ExprId side) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<SignedTerm>> by_span;
    std::vector<ExprId> written;
    for (const SignedTerm& term : signed_terms(tree_, side)) {
      const Span span = tree_[term.id].span;
      if (span.empty()) {
        written.push_back(term.id);
      } else {
        by_span[{span.begin, span.end}].push_back(term);
      }
    }
    for (const auto& [place, terms] : by_span) {
      if (terms.size() == 1 || tree_[terms[0].id].rank > 1) {
        for (const SignedTerm& term : terms) written.push_back(term.id);
        continue;
      }
      std::vector<ExprId> parts;
      for (const SignedTerm& term : terms) {
        const ExprNode node = tree_[term.id];
        parts.push_back(
            term.negative
                ? tree_.add({.op = Op::negate, .rank = node.rank, .span = node.span, .axes = node.axes},
                            std::span(&term.id, 1))
                : term.id);
      }
      const ExprNode first = tree_[terms[0].id];
      written.push_back(
          tree_.add({.op = Op::add, .rank = first.rank, .span = first.span, .axes = first.axes}, parts));
    }
    return written;
  }

  /// Not those of an angle or an exponent: a sample has `\sin Q`, and no Q, also beside `\ddot Q`.
  void add_letters(ExprId id) {
    const ExprNode& node = tree_[id];
    if (node.op == Op::function) {
      for (const SymbolId inside : symbols_in(tree_, id)) inside_.insert(inside);
      return;
    }
    if (node.op == Op::symbol) {
      const bool rate = tree_.symbols[node.symbol].derivation.has_value();
      (rate ? differentiated_ : letters_).insert(base_of(tree_.symbols, node.symbol));
    }
    for (const ExprId child : tree_.children(id)) add_letters(child);
  }

  /// `\sin\theta = \sin\phi` and `\sin\theta = -\sin\phi` are met where both are 0.
  void add_angles(ExprId side) {
    for (const ExprId id : nodes_below(tree_, {side})) {
      const ExprNode& node = tree_[id];
      const bool angle = node.op == Op::function && tree_[tree_.children(id)[0]].op == Op::symbol &&
                         (node.function == Function::sin || node.function == Function::cos);
      if (angle) angles_.insert(id);
    }
  }

  /// `a\cos\omega t`: where it is not 0, exact samples seldom reach; its letters are asked.
  [[nodiscard]] bool has_function(ExprId side) const {
    return std::ranges::any_of(nodes_below(tree_, {side}),
                               [&](ExprId id) { return tree_[id].op == Op::function; });
  }

  /// `\dot m v` of `d(mv)/dt` where m is constant: a term that nobody wrote.
  [[nodiscard]] bool has_factor(ExprId term, const std::set<SymbolId>& among) const {
    const ExprNode& node = tree_[term];
    const std::span<const ExprId> children = tree_.children(term);
    if (node.op == Op::symbol) return among.contains(node.symbol);
    if (node.op == Op::divide) return has_factor(children[0], among);
    const bool product =
        node.op == Op::multiply || node.op == Op::negate || node.op == Op::dot || node.op == Op::cross;
    return product && std::ranges::any_of(children, [&](ExprId each) { return has_factor(each, among); });
  }

  [[nodiscard]] std::optional<Equation> is_not_zero(ExprId expr) {
    const ExprNode node = tree_[expr];
    if (node.rank > 1 || symbols_in(tree_, expr).empty()) return std::nullopt;
    Equation condition;
    condition.left = expr;
    if (node.rank == 1) {
      const std::array sides{expr, expr};
      condition.left = tree_.add({.op = Op::dot, .span = node.span}, sides);
    }
    condition.right = tree_.add_number(node.span, "0");
    condition.relation = Relation::unequal;
    return condition;
  }

  ExprTree& tree_;
  std::set<SymbolId> letters_;
  std::set<SymbolId> differentiated_;  // those that have a derivative there
  std::set<SymbolId> inside_;          // of functions
  std::set<SymbolId> zero_;            // set equal to 0 as they stand
  std::set<ExprId> sides_;
  std::set<ExprId> angles_;  // sines and cosines of letters
  std::vector<ExprId> terms_;
  std::vector<std::vector<ExprId>> vanishing_;  // the terms of each sum that is set equal to 0
};

int order_in_time(const ExprTree& tree, std::span<const ExprId> sides) {
  int order = 0;
  for (const ExprId side : sides) {
    for (const SymbolId symbol : symbols_in(tree, side))
      order = std::max(order, tree.symbols[symbol].order(By::time));
  }
  return order;
}

/// `\nabla(\nabla\cdot\mathbf E)` of the law `\nabla\cdot\mathbf E = 0`: the written 0 says so, at every
/// place. What is 0 at one time says nothing of rates.
bool is_said_to_vanish(const Prepared& prepared, ExprTree& tree, ExprId term, const PageLaw& law,
                       DecisionCache* cache) {
  const std::array sides{law.equation.left, law.equation.right};
  const bool written = std::ranges::any_of(sides, [&](ExprId side) { return tree.is_zero_literal(side); });
  const ExprNode node = tree[term];
  if (!written || law.at_instant || node.slot_count > 0) return false;
  if (order_in_time(tree, std::span(&term, 1)) > order_in_time(tree, sides)) return false;
  Question question{.tree = &tree,
                    .claim = {.left = term, .right = zero_of_rank(tree, node.span, node.rank, node.axes)},
                    .definitions = prepared.question.definitions};
  for (std::size_t k = 0; k < prepared.assumptions.size(); ++k) {
    const NamedAssumption* named = prepared.assumptions[k];
    if (named != nullptr && named->origin.text == law.name)
      question.assumptions.push_back(prepared.question.assumptions[k]);
  }
  constexpr Limits few{
      .expanded_terms = 20'000, .steps = 50'000, .sample_attempts = 1, .simplest_sample = false};
  return decide(cache, question, few).outcome == Outcome::proved;
}

/// \Delta S of `\Delta S = C\ln(T_2/T_1)`: exact samples of
/// logarithms, exponentials and roots are few.
bool is_reckoned_by_functions(const ExprTree& tree, const Question& question, ExprId expr) {
  const auto body_of = [&](SymbolId symbol) -> std::optional<ExprId> {
    const auto found = std::ranges::find(question.definitions, symbol, &Definition::symbol);
    return found == question.definitions.end() ? std::nullopt : std::optional(found->body);
  };
  std::vector<ExprId> roots{expr};
  for (const SymbolId each : symbols_reached(tree, {expr}, body_of)) {
    if (const auto body = body_of(each)) roots.push_back(*body);
  }
  return std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    const ExprNode& node = tree[id];
    return node.op == Op::real_power || node.op == Op::root || node.op == Op::function;
  });
}

bool has_functions(const Question& question) {
  return std::ranges::any_of(question.assumptions, [&](const Equation& each) {
    return is_reckoned_by_functions(*question.tree, question, each.left) ||
           is_reckoned_by_functions(*question.tree, question, each.right);
  });
}

}  // namespace

bool is_met_without_zeros(ExprTree& tree, const Names& names, const Equation& claim,
                          const std::vector<const PageLaw*>& laws, DecisionCache* cache) {
  NonZero nonzero(tree);
  nonzero.add(claim);
  for (const PageLaw* law : laws) nonzero.add(law->equation);
  // What the laws say of rates is met, too: `v = \omega r` and `\dot v = \dot\omega r` leave only r at rest.
  Prepared prepared = prepare(tree, names, claim);
  if (speaks_of_derivatives(prepared)) {
    Prepared further = prepare(tree, names, claim, 1);
    if (!further.too_large) prepared = std::move(further);
  }
  for (const ExprId term : std::vector(nonzero.terms())) {
    const bool vanishes = std::ranges::any_of(
        laws, [&](const PageLaw* law) { return is_said_to_vanish(prepared, tree, term, *law, cache); });
    if (vanishes) nonzero.let_vanish(term);
  }
  Question question = std::move(prepared.question);
  for (Equation& condition : nonzero.conditions(question.zeroed))
    question.assumptions.push_back(std::move(condition));
  question.tree = &tree;
  if (satisfying_sample(cache, question, {}, {})) return true;
  return has_functions(question) &&
         is_met_at_rough_points(question, cache == nullptr ? nullptr : &cache->budget());
}

}  // namespace rigor
