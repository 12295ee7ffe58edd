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
std::optional<DifferentialEquation> order_in(const ExprTree& tree, const Equation& equation,
                                             SymbolId unknown) {
  std::optional<DifferentialEquation> found;
  for (const ExprId id : nodes_below(tree, {equation.left, equation.right})) {
    if (tree[id].op != Op::symbol) continue;
    const auto& derivation = tree.symbols[tree[id].symbol].derivation;
    if (!derivation || derivation->base != unknown) continue;
    DifferentialEquation own{equation, unknown, *derivation->by.begin(), 0,
                             static_cast<int>(derivation->by.size())};
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

/// Does another row say what the unknown is, below the one that begins the problem? Then its constants are
/// not free any more; but a general solution with other constants is one still, below another one.
bool is_solved_since(const ExprTree& tree, const Laws& bearing, SymbolId unknown, Span begin,
                     bool is_general) {
  const auto is_it = [&](ExprId side) { return tree[side].op == Op::symbol && tree[side].symbol == unknown; };
  return std::ranges::any_of(bearing, [&](const PageLaw* law) {
    const bool above = law->span.file == begin.file && law->span.begin < begin.begin;
    const bool solves = is_general && law->standing == Standing::result;
    return !above && !solves && (is_it(law->equation.left) || is_it(law->equation.right));
  });
}

/// N(s): for which s that is the constant, nothing says. `N(t_0)` names one place.
bool is_value_anywhere(const RowUnderLaws& row, SymbolId letter) {
  const auto value = row.names.symbols.function_values.find(letter);
  if (value == nullptr) return false;
  return std::ranges::any_of(value->second.at, [&](ExprId at) {
    return std::ranges::any_of(symbols_in(row.tree, at), [&](SymbolId each) {
      const Symbol& symbol = row.tree.symbols[each];
      return !symbol.is_fixed() && symbol.name.find("_{") == std::string::npos;
    });
  });
}

/// The letters of the solution that no equation has had before, and that do not change.
std::vector<SymbolId> free_constants(const RowUnderLaws& row, const Equation& law,
                                     const std::vector<ValueCondition>& conditions) {
  const Equation right{.left = row.claim.equation.right, .right = row.claim.equation.right};
  std::set<SymbolId> known = base_letters(row.tree, row.names.scope, law);
  for (const ValueCondition& each : conditions) {
    const std::vector<SymbolId> where = symbols_in(row.tree, each.at);  // h of `u(h) = 0`
    known.insert(where.begin(), where.end());
  }
  std::vector<SymbolId> constants;
  for (const SymbolId letter : base_letters(row.tree, row.names.scope, right)) {
    const Symbol& symbol = row.tree.symbols[letter];
    const NameKey* key = key_of(row.names.symbols, letter);
    const bool plain = symbol.rank == 0 && !symbol.per_particle && !symbol.is_fixed() && key != nullptr &&
                       definition_of(row.names.scope, letter) == nullptr;
    if (!plain || known.contains(letter) || is_value_anywhere(row, letter)) continue;
    if (seen_in_equation(row.names.scope, letter)) continue;
    const bool changes = may_be_changing(*row.names.symbols.evidence, key->base) &&
                         !is_function_value(row.names, row.tree, letter);
    if (!changes && constants.size() < most_constants) constants.push_back(letter);
  }
  return constants;
}

class Independence {
 public:
  Independence(const RowUnderLaws& row, const Names& names, const DifferentialEquation& order)
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
  const DifferentialEquation& order_;
  DerivativeBudget budget_;
};

/// With the solution put in, does the law follow from these others? They are met by more than zeros.
std::optional<Judgement> holds_when_put_in(const RowUnderLaws& put_in, const Names& names, const Laws& others,
                                           Variable by) {
  const Names assumed = with_laws(put_in.tree, with_constants_of_solution(put_in, by), others);
  Judgement judgement = judge(put_in.tree, assumed, put_in.claim, {}, put_in.cache);
  if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
  Laws used;
  std::ranges::copy_if(others, std::back_inserter(used),
                       [&](const PageLaw* law) { return is_one_of(law->name, judgement.uses); });
  const bool met = used.empty() || is_met_without_zeros(put_in.tree, with_laws(put_in.tree, names, used),
                                                        put_in.claim.equation, used, put_in.cache);
  return met ? std::optional(std::move(judgement)) : std::nullopt;
}

/// Does it speak of values of functions, and of letters that no function of it is, nor runs over?
bool is_of_values_alone(const RowUnderLaws& row, const std::vector<SymbolId>& written) {
  const auto& values = row.names.symbols.function_values;
  bool found = false;
  for (const SymbolId each : written) {
    const auto value = values.find(each);
    if (value == nullptr) continue;
    found = true;
    if (is_value_anywhere(row, each)) return false;
    for (const SymbolId other : written) {
      const bool runs = base_of(row.tree.symbols, value->second.of) == base_of(row.tree.symbols, other) ||
                        is_one_of(row.tree.symbols[other].name, value->second.variables);
      if (!values.contains(other) && runs) return false;
    }
  }
  return found;
}

/// x_0 of `x(0) = x_0`, h and U of `u(h) = U`: what a function is somewhere does not change, nor does the
/// place.
std::vector<SymbolId> letters_of_values(const RowUnderLaws& row, const Laws& available) {
  const auto is_plain = [&](SymbolId each) {
    const Symbol& symbol = row.tree.symbols[each];
    const NameKey* key = key_of(row.names.symbols, each);
    return symbol.rank == 0 && !symbol.per_particle && !symbol.is_fixed() && key != nullptr &&
           !row.names.symbols.evidence->applied.contains(key->base) &&
           !has_rate(*row.names.symbols.sightings, *key) && !symbol.derivation &&
           definition_of(row.names.scope, each) == nullptr;
  };
  std::vector<SymbolId> letters;
  for (const PageLaw* law : available) {
    std::vector<SymbolId> written = symbols_in(row.tree, law->equation.left);
    std::ranges::copy(symbols_in(row.tree, law->equation.right), std::back_inserter(written));
    if (!is_of_values_alone(row, written)) continue;
    std::erase_if(written, [&](SymbolId each) { return row.names.symbols.function_values.contains(each); });
    if (std::ranges::all_of(written, is_plain)) std::ranges::copy(written, std::back_inserter(letters));
  }
  return letters;
}

/// What follows when the row is put in.
Names with_row_put_in(const RowUnderLaws& row, SymbolId unknown, const std::vector<SymbolId>& constants) {
  Names names = row.names;
  define(names.scope,
         {{unknown, {}, no_particle, row.claim.equation.right}, {solution, {}, std::nullopt}, 0});
  for (const SymbolId each : constants) declare_constant(names.scope, each, std::nullopt);
  return names;
}

/// `y(0)` and `\dot x(0)` of `x = x(0)\cos\omega t + \dot x(0)/\omega\,\sin\omega t`; nothing where one
/// stands at several arguments.
std::optional<std::vector<SymbolId>> own_values(const RowUnderLaws& row, SymbolId unknown) {
  std::vector<SymbolId> values;
  for (const SymbolId symbol : symbols_in(row.tree, row.claim.equation.right)) {
    const auto value = row.names.symbols.function_values.find(symbol);
    if (value == nullptr) continue;
    if (base_of(row.tree.symbols, value->second.of) != unknown) continue;
    if (value->second.at.size() != 1) return std::nullopt;
    values.push_back(symbol);
  }
  return values;
}

/// `y = y(0)e^{kx}` is y(0) where x = 0, and `2y(0)e^{kx}` is not: what the unknown is somewhere is no free
/// constant. Other letters stand for these values, which the solution is then asked for.
bool has_its_own_values(const RowUnderLaws& row, const DifferentialEquation& equation,
                        const std::vector<SymbolId>& constants) {
  const auto values = own_values(row, equation.unknown);
  if (!values) return false;
  std::vector<std::pair<SymbolId, SymbolId>> letters;  // of the values, and what stands for them
  Names names = row.names;
  for (const SymbolId value : *values) {
    const Symbol& symbol = row.tree.symbols[value];
    const SymbolId letter =
        row.tree.symbols.add({.name = fmt::format("C_{{{}}}", symbol.name), .first_seen = symbol.first_seen});
    letters.emplace_back(value, letter);
    declare_constant(names.scope, letter, std::nullopt);
  }
  const auto leaf = [&](SymbolId symbol) {
    return row.tree.add({.op = Op::symbol, .span = row.claim.relation, .symbol = symbol});
  };
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const auto found = std::ranges::find(letters, row.tree[id].symbol, &std::pair<SymbolId, SymbolId>::first);
    return found == letters.end() ? std::nullopt : std::optional(leaf(found->second));
  };
  Claim put_in = row.claim;
  put_in.equation.right = replaced(row.tree, row.claim.equation.right, by);
  names = with_row_put_in({row.tree, names, put_in, row.cache}, equation.unknown, constants);
  return std::ranges::all_of(letters, [&](const auto& each) {
    Claim claim = row.claim;
    claim.equation.left = leaf(each.first);
    claim.equation.right = leaf(each.second);
    const Names constant = with_constants_of_solution({row.tree, names, claim, row.cache}, equation.by);
    const Judgement judgement = judge(row.tree, constant, claim, {}, row.cache);
    return judgement.verdict == Verdict::proved && judgement.diagnostics.empty();
  });
}

/// Does the row meet all of them?
bool meets(const RowUnderLaws& row, const Names& put_in, const std::vector<ValueCondition>& conditions,
           Variable by) {
  return std::ranges::all_of(conditions, [&](const ValueCondition& condition) {
    Claim claim = row.claim;
    claim.equation = condition.law->equation;
    const Names constant = with_constants_of_solution({row.tree, put_in, claim, row.cache}, by);
    const Judgement judgement = judge(row.tree, constant, claim, {}, row.cache);
    return judgement.verdict == Verdict::proved && judgement.diagnostics.empty();
  });
}

}  // namespace

std::optional<SymbolId> letter_of_particular_solution(const Names& names, SymbolId letter) {
  const NameKey* key = key_of(names.symbols, letter);
  if (key == nullptr) return std::nullopt;
  const std::string bare = without_labels(key->base);
  const std::string_view label = std::string_view(key->base).substr(bare.size());
  if (!is_one_of(label, {"_p", "_{p}", "_{part}", "_{\\mathrm{p}}", "_{\\mathrm{part}}"}))
    return std::nullopt;
  NameKey of = *key;
  of.base = bare;
  return find_symbol(names.symbols, of);
}

std::optional<SolvedEquation> solved_equation(const RowUnderLaws& row, const Laws& bearing) {
  auto unknown = unknown_of(row);
  if (!unknown) return std::nullopt;
  const auto of_particular = letter_of_particular_solution(row.names, *unknown);
  if (of_particular) unknown = of_particular;
  std::optional<SolvedEquation> found;
  Laws others;
  for (const PageLaw* each : bearing) {
    const bool of_unknown = base_letters(row.tree, row.names.scope, each->equation).contains(*unknown);
    if (!found && of_unknown && !each->at_instant) {
      if (const auto order = order_in(row.tree, each->equation, *unknown))
        found = SolvedEquation{*order, each};
    }
    if (!of_unknown && others.size() < most_other_laws) others.push_back(each);
  }
  if (found) found->others = std::move(others);
  if (found) found->particular = of_particular.has_value();
  return found;
}

std::optional<Equation> put_in(ExprTree& tree, const Names& names, const DifferentialEquation& equation,
                               ExprId function) {
  DerivativeBudget budget;
  const auto dependence_of = [&](SymbolId symbol) {
    const Dependence known = change(names, tree, symbol, equation.by).dependence;
    const bool guessed =
        known.kind == Dependence::Kind::varies && !knows_change(names, tree, symbol, equation.by);
    return guessed ? Dependence{Dependence::Kind::constant} : known;
  };
  Differentiator differentiate(tree, equation.by, dependence_of, budget, {equation.axis, {}});
  std::vector<ExprId> derivatives{function};
  for (int k = 0; k < equation.order; ++k)
    derivatives.push_back(differentiate.derivative_or_zero(derivatives.back()));
  if (budget.exceeded) return std::nullopt;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const SymbolId symbol = tree[id].symbol;
    if (base_of(tree.symbols, symbol) != equation.unknown) return std::nullopt;
    return derivatives[tree.symbols[symbol].derivation ? tree.symbols[symbol].derivation->by.size() : 0];
  };
  Equation result = equation.equation;
  result.left = replaced(tree, result.left, by);
  result.right = replaced(tree, result.right, by);
  return result;
}

std::optional<Judgement> solves(const RowUnderLaws& row, const Laws& bearing, const Laws& available) {
  const auto solved = solved_equation(row, bearing);
  if (!solved) return std::nullopt;
  const DifferentialEquation& of = solved->of;
  std::vector<ValueCondition> conditions;
  if (!solved->particular) conditions = conditions_on(row.tree, row.names, available, of.unknown);
  const std::vector<SymbolId> constants = free_constants(row, solved->law->equation, conditions);
  const bool is_general = static_cast<int>(constants.size()) >= of.order;
  if (is_general) conditions.clear();  // they say what the constants are
  std::vector<SymbolId> known = letters_of_values(row, available);
  known.insert(known.end(), constants.begin(), constants.end());
  const Span begin = conditions.empty() ? solved->law->span : conditions.front().law->span;
  const bool any = solved->particular;
  if (!any && is_solved_since(row.tree, bearing, of.unknown, begin, is_general)) return std::nullopt;
  if (!any && !is_general && (!constants.empty() || !leave_one_solution(row.tree, row.names, of, conditions)))
    return std::nullopt;
  const Names names = with_row_put_in(row, of.unknown, known);
  Claim claim = row.claim;
  claim.equation = solved->law->equation;
  const RowUnderLaws put_in{row.tree, names, claim, row.cache};
  auto found = holds_when_put_in(put_in, row.names, {}, of.by);
  if (!found && !solved->others.empty()) found = holds_when_put_in(put_in, row.names, solved->others, of.by);
  if (!found) return std::nullopt;
  const Names constant = with_constants_of_solution(put_in, of.by);
  if (!any && is_general && !Independence(row, constant, of).holds(constants)) return std::nullopt;
  if (!meets(row, names, conditions, of.by) || !has_its_own_values(row, of, known)) return std::nullopt;
  std::erase(found->uses, solution);
  for (const ValueCondition& each : conditions) found->uses.insert(found->uses.begin(), each.law->name);
  found->uses.insert(found->uses.begin(), solved->law->name);
  found->uses.emplace_back("convention: what nothing differentiates is constant");
  found->route = fmt::format("solves {}", solved->law->name);
  return found;
}

}  // namespace rigor
