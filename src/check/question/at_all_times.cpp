// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/at_all_times.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "base/among.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

bool speaks_of(const ExprTree& tree, const Names& names, ExprId root, By by) {
  return std::ranges::any_of(symbols_in(tree, root),
                             [&](SymbolId each) { return is_free_variable(names, tree, each, by); });
}

/// Is there no value at 0, perhaps, or one that is not approached from both sides?
bool may_fail_at_zero(const ExprTree& tree, const Names& names, ExprId root) {
  const ExprNode& node = tree[root];
  const auto speaks = [&](ExprId id) { return speaks_of(tree, names, id, By::time); };
  if (node.op == Op::divide && speaks(tree.children(root)[1])) return true;
  if (node.op == Op::power && node.exponent < 0 && speaks(root)) return true;
  if (node.op == Op::root && speaks(root)) return true;
  return std::ranges::any_of(tree.children(root),
                             [&](ExprId child) { return may_fail_at_zero(tree, names, child); });
}

/// Is it defined, or its rate given?
bool is_ruled(const ExprTree& tree, const Names& names, SymbolId base) {
  return std::ranges::any_of(names.scope.definitions, [&](const NamedDefinition& each) {
    return base_of(tree.symbols, each.definition.symbol) == base;
  });
}

/// The quantities that change with the time, and which the assumption could be solved for.
std::set<SymbolId> changing_in(const ExprTree& tree, const Names& names, const Prepared& prepared,
                               const Equation& equation) {
  std::set<SymbolId> changing;
  const auto body_of = [&](SymbolId symbol) {
    const Definition* known = definition_in(prepared.question, symbol);
    return known == nullptr ? std::nullopt : std::optional(known->body);
  };
  for (const SymbolId symbol : symbols_reached(tree, {equation.left, equation.right}, body_of)) {
    const SymbolId base = base_of(tree.symbols, symbol);
    if (body_of(symbol) || is_ruled(tree, names, base)) continue;
    if (is_free_variable(names, tree, base, By::space)) continue;
    if (change(names, tree, base, By::time).dependence.kind == Dependence::Kind::varies)
      changing.insert(base);
  }
  return changing;
}

/// Each equation gets one changing quantity; others give theirs up where they have another one.
class Matching {
 public:
  explicit Matching(std::vector<std::set<SymbolId>> choices) : choices_(std::move(choices)) {}

  bool serve(std::size_t equation) {
    tried_.clear();
    return place(equation);
  }

 private:
  bool place(std::size_t equation) {
    for (const SymbolId choice : choices_[equation]) {
      if (!tried_.insert(choice).second) continue;
      const auto holder = holder_.find(choice);
      if (holder != holder_.end() && !place(holder->second)) continue;
      holder_[choice] = equation;
      return true;
    }
    return false;
  }

  std::vector<std::set<SymbolId>> choices_;
  std::map<SymbolId, std::size_t> holder_;
  std::set<SymbolId> tried_;
};

bool speaks_of_any(const ExprTree& tree, const Names& names, const Equation& equation) {
  return runs_with_time(tree, names, equation) || speaks_of(tree, names, equation.left, By::space) ||
         speaks_of(tree, names, equation.right, By::space);
}

/// Does the symbol occur in the argument of a function?
bool is_argument(const ExprTree& tree, ExprId root, SymbolId symbol) {
  const std::vector<SymbolId> inside = symbols_in(tree, root);
  if (!is_one_of(symbol, inside)) return false;
  if (tree[root].op == Op::function) return true;
  return std::ranges::any_of(tree.children(root),
                             [&](ExprId child) { return is_argument(tree, child, symbol); });
}

}  // namespace

bool runs_with_time(const ExprTree& tree, const Names& names, const Equation& equation) {
  bool time = false;
  bool known = false;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const SymbolId base = base_of(tree.symbols, symbol);
      const NamedDefinition* named = definition_of(names.scope, base);
      if (named != nullptr && symbols_in(tree, named->definition.body).empty()) return false;
      if (is_free_variable(names, tree, symbol, By::time)) {
        time = true;
      } else {
        known = known || knows_change(names, tree, base, By::time);
      }
    }
  }
  return time && known;
}

std::optional<Equation> at_time_zero(ExprTree& tree, const Names& names, const Equation& equation) {
  if (equation.relation != Relation::equal || !runs_with_time(tree, names, equation)) return std::nullopt;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const bool time = is_free_variable(names, tree, symbol, By::time);
      const bool constant =
          change(names, tree, symbol, By::time).dependence.kind == Dependence::Kind::constant;
      if ((!time && !constant) || definition_of(names.scope, symbol) != nullptr) return std::nullopt;
    }
    if (may_fail_at_zero(tree, names, side)) return std::nullopt;
  }
  const auto zero = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree[id];
    if (!is_free_variable(names, tree, node.symbol, By::time)) return std::nullopt;
    return tree.add_number(node.span, "0");
  };
  Equation result = equation;
  result.left = replaced(tree, equation.left, zero);
  result.right = replaced(tree, equation.right, zero);
  return result;
}

const NamedAssumption* unmatched_assumption(const ExprTree& tree, const Names& names,
                                            const Prepared& prepared) {
  std::vector<const NamedAssumption*> equations;
  for (const NamedAssumption* each : prepared.assumptions) {
    const bool fits =
        each != nullptr && each->equation.relation == Relation::equal && !is_one_of(each, equations);
    if (fits) equations.push_back(each);
  }
  std::vector<std::set<SymbolId>> choices;
  std::set<SymbolId> timed;  // what changes in an equation that speaks of the time or place
  std::vector<bool> speaks;
  for (const NamedAssumption* each : equations) {
    choices.push_back(changing_in(tree, names, prepared, each->equation));
    speaks.push_back(speaks_of_any(tree, names, each->equation));
    if (speaks.back()) timed.insert(choices.back().begin(), choices.back().end());
  }
  if (!is_one_of(true, speaks)) return nullptr;
  Matching matching(choices);
  for (std::size_t k = 0; k < equations.size(); ++k) {
    const bool shares =
        speaks[k] || std::ranges::any_of(choices[k], [&](SymbolId each) { return timed.contains(each); });
    if (shares && !matching.serve(k)) return equations[k];
  }
  return nullptr;
}

std::vector<Equation> somewhere(ExprTree& tree, const Names& names, const std::vector<Equation>& equations,
                                By by) {
  static constexpr std::array numerators{"5", "3", "2"};
  static constexpr std::array denominators{"7", "11", "13"};
  std::set<SymbolId> variables;
  std::set<SymbolId> arguments;
  for (const Equation& equation : equations) {
    for (const ExprId side : {equation.left, equation.right}) {
      for (const SymbolId symbol : symbols_in(tree, side)) {
        if (!is_free_variable(names, tree, symbol, by)) continue;
        variables.insert(symbol);
        if (is_argument(tree, side, symbol)) arguments.insert(symbol);
      }
    }
  }
  std::vector<Equation> values;
  for (const SymbolId symbol : variables) {
    if (arguments.contains(symbol)) continue;
    const Span span = tree.symbols[symbol].first_seen;
    const auto rank = static_cast<std::uint8_t>(tree.symbols[symbol].rank);
    std::vector<ExprId> numbers;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array parts{tree.add_number(span, numerators[k]), tree.add_number(span, denominators[k])};
      numbers.push_back(tree.add({.op = Op::divide, .span = span}, parts));
    }
    Equation value;
    value.left = tree.add({.op = Op::symbol, .rank = rank, .span = span, .symbol = symbol});
    value.right = rank == 0 ? numbers[values.size() % 3]
                            : tree.add({.op = Op::tuple, .rank = 1, .span = span}, numbers);
    values.push_back(value);
  }
  return values;
}

}  // namespace rigor
