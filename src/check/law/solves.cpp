// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/solves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/law/bearing.h"
#include "check/law/witness.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr const char* solution = "the solution";
constexpr std::size_t most_constants = 6;
constexpr std::size_t most_other_laws = 3;

/// u of `u(x, t)`, or of `\partial u/\partial t`: its "constants" can be functions.
bool depends_on_several(const RowUnderLaws& row, SymbolId unknown) {
  const NameKey* key = key_of(row.names.symbols, unknown);
  if (key == nullptr || row.names.symbols.sightings->partial_rates.contains({key->base, false})) return true;
  const auto& applied = row.names.symbols.evidence->applied;
  const auto found = applied.find(key->base);
  return found != applied.end() &&
         std::ranges::any_of(found->second, [](const auto& letters) { return letters.size() > 1; });
}

/// The letter alone on the left side, which nothing defines and the right side has not.
std::optional<SymbolId> unknown_of(const RowUnderLaws& row) {
  const Equation& equation = row.claim.equation;
  const ExprNode& left = row.tree[equation.left];
  const bool alone = equation.relation == Relation::equal && left.op == Op::symbol && left.rank == 0 &&
                     left.slot_count == 0 && left.particle == no_particle && equation.indices.empty();
  if (!alone || row.tree.symbols[left.symbol].derivation) return std::nullopt;
  if (definition_of(row.names.scope, left.symbol) != nullptr || depends_on_several(row, left.symbol))
    return std::nullopt;
  const Equation right{.left = equation.right, .right = equation.right};
  if (base_letters(row.tree, row.names.scope, right).contains(left.symbol)) return std::nullopt;
  return left.symbol;
}

/// What an equation differentiates the unknown by, as often as it does; nothing: not at all, or by several
/// variables or places.
struct Order {
  Variable by;
  std::uint8_t axis = 0;  // by a place: which
  int order = 0;
};

std::optional<Order> order_in(const ExprTree& tree, const Equation& equation, SymbolId unknown) {
  std::optional<Order> found;
  for (const ExprId id : nodes_below(tree, {equation.left, equation.right})) {
    if (tree[id].op != Op::symbol) continue;
    const auto& derivation = tree.symbols[tree[id].symbol].derivation;
    if (!derivation || derivation->base != unknown) continue;
    Order own{*derivation->by.begin(), 0, static_cast<int>(derivation->by.size())};
    const std::span<const Slot> slots = tree.slots(id);
    if (own.by == By::space && !slots.empty()) own.axis = slots[0].axis;
    const bool along = std::ranges::all_of(slots, [&](const Slot& slot) { return slot.axis == own.axis; });
    const bool one = derivation->by.count(own.by) == derivation->by.size() && own.by != By::small && along &&
                     (own.by == By::space) == (own.axis != 0);
    if (!one || (found && (found->by != own.by || found->axis != own.axis))) return std::nullopt;
    if (!found || found->order < own.order) found = own;
  }
  return found;
}

/// Does another row say what the unknown is? Then its constants are not free any more.
bool is_solved_already(const ExprTree& tree, const Laws& bearing, SymbolId unknown) {
  const auto is_it = [&](ExprId side) { return tree[side].op == Op::symbol && tree[side].symbol == unknown; };
  return std::ranges::any_of(
      bearing, [&](const PageLaw* law) { return is_it(law->equation.left) || is_it(law->equation.right); });
}

/// The letters of the solution that no equation has had before, and that do not change.
std::vector<SymbolId> free_constants(const RowUnderLaws& row, const Equation& law) {
  const Equation right{.left = row.claim.equation.right, .right = row.claim.equation.right};
  const std::set<SymbolId> known = base_letters(row.tree, row.names.scope, law);
  std::vector<SymbolId> constants;
  for (const SymbolId letter : base_letters(row.tree, row.names.scope, right)) {
    const Symbol& symbol = row.tree.symbols[letter];
    const NameKey* key = key_of(row.names.symbols, letter);
    const bool plain = symbol.rank == 0 && !symbol.per_particle && !symbol.is_fixed() && key != nullptr &&
                       definition_of(row.names.scope, letter) == nullptr;
    if (!plain || known.contains(letter)) continue;
    if (seen_in_equation(row.names.scope, letter)) continue;
    const bool changes = may_be_changing(*row.names.symbols.evidence, key->base) &&
                         !is_function_value(row.names, row.tree, letter);
    if (!changes && constants.size() < most_constants) constants.push_back(letter);
  }
  return constants;
}

class Independence {
 public:
  Independence(const RowUnderLaws& row, const Names& names, const Order& order)
      : row_(row), names_(names), order_(order) {}

  /// Do so many of the constants take the solution and its derivatives to any values?
  bool holds(const std::vector<SymbolId>& constants) {
    const ExprId x = row_.claim.equation.right;
    if (order_.order == 1)
      return std::ranges::any_of(constants, [&](SymbolId each) { return !vanishes(by(x, each)); });
    if (order_.order != 2) return false;
    Differentiator rate(
        row_.tree, order_.by,
        [&](SymbolId symbol) { return change(names_, row_.tree, symbol, order_.by).dependence; }, budget_,
        {order_.axis, {}});
    const ExprId v = rate.derivative_or_zero(x);
    for (std::size_t a = 0; a < constants.size(); ++a) {
      for (std::size_t b = a + 1; b < constants.size(); ++b) {
        const ExprId first = product(by(x, constants[a]), by(v, constants[b]));
        const ExprId second = product(by(x, constants[b]), by(v, constants[a]));
        const ExprId negated = row_.tree.add({.op = Op::negate}, std::span(&second, 1));
        const std::array terms{first, negated};
        if (!vanishes(row_.tree.add({.op = Op::add}, terms))) return true;
      }
    }
    return false;
  }

 private:
  ExprId by(ExprId of, SymbolId constant) {
    const auto dependence_of = [&](SymbolId symbol) {
      return Dependence{symbol == constant ? Dependence::Kind::variable : Dependence::Kind::constant};
    };
    return Differentiator(row_.tree, {By::letter, constant}, dependence_of, budget_).derivative_or_zero(of);
  }

  ExprId product(ExprId one, ExprId other) {
    const std::array factors{one, other};
    return row_.tree.add({.op = Op::multiply}, factors);
  }

  bool vanishes(ExprId expr) {
    Equation equation;
    equation.left = expr;
    equation.right = row_.tree.add_number({}, "0");
    const Prepared prepared = prepare(row_.tree, names_, equation);
    if (prepared.too_large || budget_.exceeded) return true;
    return decide(row_.cache, prepared.question, {}).outcome == Outcome::proved;
  }

  const RowUnderLaws& row_;
  const Names& names_;
  const Order& order_;
  DerivativeBudget budget_;
};

/// With the solution put in, does the law follow from these others? They are met by more than zeros.
std::optional<Judgement> holds_when_put_in(const RowUnderLaws& put_in, const Names& names,
                                           const Laws& others) {
  const Names assumed = with_laws(put_in.tree, with_laws_and_constants(put_in, {}), others);
  Judgement judgement = judge(put_in.tree, assumed, put_in.claim, {}, put_in.cache);
  if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
  Laws used;
  std::ranges::copy_if(others, std::back_inserter(used),
                       [&](const PageLaw* law) { return is_one_of(law->name, judgement.uses); });
  const bool met = used.empty() || is_met_without_zeros(put_in.tree, with_laws(put_in.tree, names, used),
                                                        put_in.claim.equation, used, put_in.cache);
  return met ? std::optional(std::move(judgement)) : std::nullopt;
}

}  // namespace

std::optional<Judgement> solves(const RowUnderLaws& row, const Laws& bearing) {
  const auto unknown = unknown_of(row);
  if (!unknown) return std::nullopt;
  const PageLaw* law = nullptr;
  std::optional<Order> order;
  Laws others;
  for (const PageLaw* each : bearing) {
    const bool of_unknown = base_letters(row.tree, row.names.scope, each->equation).contains(*unknown);
    if (law == nullptr && of_unknown && !each->at_instant && !each->of_a_case) {
      order = order_in(row.tree, each->equation, *unknown);
      if (order) law = each;
    }
    if (!of_unknown && others.size() < most_other_laws) others.push_back(each);
  }
  if (law == nullptr || is_solved_already(row.tree, bearing, *unknown)) return std::nullopt;
  const std::vector<SymbolId> constants = free_constants(row, law->equation);
  if (static_cast<int>(constants.size()) < order->order) return std::nullopt;
  Names names = row.names;
  define(names.scope,
         {{*unknown, {}, no_particle, row.claim.equation.right}, {solution, {}, std::nullopt}, 0});
  for (const SymbolId each : constants) declare_constant(names.scope, each, std::nullopt);
  Claim claim = row.claim;
  claim.equation = law->equation;
  const RowUnderLaws put_in{row.tree, names, claim, row.cache};
  auto found = holds_when_put_in(put_in, row.names, {});
  if (!found && !others.empty()) found = holds_when_put_in(put_in, row.names, others);
  if (!found) return std::nullopt;
  const Names constant = with_laws_and_constants(put_in, {});
  if (!Independence(row, constant, *order).holds(constants)) return std::nullopt;
  std::erase(found->uses, solution);
  found->uses.insert(found->uses.begin(), law->name);
  found->uses.emplace_back("convention: what nothing differentiates is constant");
  found->route = fmt::format("solves {}", law->name);
  return found;
}

}  // namespace rigor
