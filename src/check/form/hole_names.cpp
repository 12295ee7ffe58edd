// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/hole_names.h"

#include <algorithm>
#include <set>

#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr std::size_t most_candidates = 200;
constexpr std::size_t most_names = 3;
constexpr Limits limits_of_names{.expanded_terms = 10'000,
                                 .steps = 60'000,
                                 .quick_points = 2,
                                 .quick_steps = 4'000,
                                 .sample_attempts = 12,
                                 .fewest_assumptions = false,
                                 .simplest_sample = false};

class NameTrial {
 public:
  NameTrial(ExprTree& tree, const Names& names, const Claim& claim, HoleReading& reading)
      : tree_(tree), names_(names), claim_(claim), reading_(reading) {}

  void run() {
    reading_.takes_anything = holds(claim_.equation);
    if (reading_.takes_anything) return;
    for (const SymbolId symbol : symbols_in_scope()) try_symbol(symbol);
  }

 private:
  bool holds(const Equation& equation) {
    Claim claim = claim_;
    claim.equation = equation;
    return judge(tree_, names_, claim, limits_of_names).verdict == Verdict::proved;
  }

  std::vector<SymbolId> symbols_in_scope() const {
    std::set<SymbolId> own;
    for (const ExprId side : {claim_.equation.left, claim_.equation.right}) {
      for (const SymbolId symbol : symbols_in(tree_, side)) own.insert(symbol);
    }
    std::vector<SymbolId> defined;
    std::vector<SymbolId> others;
    for (std::size_t k = 0; k < tree_.symbols.size(); ++k) {
      const SymbolId symbol{static_cast<std::uint32_t>(k)};
      if (own.contains(symbol) || tree_.symbols[symbol].derivation) continue;
      if (definition_of(names_.scope, symbol) != nullptr) {
        defined.push_back(symbol);
      } else if (seen_in_equation(names_.scope, symbol)) {
        others.push_back(symbol);
      }
    }
    defined.insert(defined.end(), others.begin(), others.end());
    return defined;
  }

  void try_symbol(SymbolId symbol) {
    const ExprNode hole = tree_[reading_.node];
    const Symbol& known = tree_.symbols[symbol];
    if (known.per_particle && hole.particle == no_particle) return;
    const auto own = tree_.slots(reading_.node);
    std::vector<Slot> slots(own.begin(), own.end());
    const bool whole = hole.rank > 0 && hole.rank == known.rank && slots.empty();
    const bool lettered = hole.rank == 0 && static_cast<int>(slots.size()) == known.rank;
    if (!whole && !lettered) return;
    const auto by_letter = [](const Slot& a, const Slot& b) { return a.variable < b.variable; };
    std::vector<Slot> order = slots;
    std::ranges::sort(order, by_letter);
    try_at(symbol, slots);
    const bool one_order = known.symmetric || slots.size() < 2 || slots.size() > 3;
    do {
      if (one_order || is_same(order, slots)) continue;
      try_at(symbol, order);
    } while (std::next_permutation(order.begin(), order.end(), by_letter));
  }

  static bool is_same(const std::vector<Slot>& a, const std::vector<Slot>& b) {
    return std::ranges::equal(
        a, b, [](const Slot& x, const Slot& y) { return x.variable == y.variable && x.axis == y.axis; });
  }

  void try_at(SymbolId symbol, const std::vector<Slot>& slots) {
    const ExprNode hole = tree_[reading_.node];
    const ExprId name =
        tree_.add({.op = Op::symbol,
                   .rank = hole.rank,
                   .span = hole.span,
                   .symbol = symbol,
                   .particle = tree_.symbols[symbol].per_particle ? hole.particle : no_particle},
                  {}, slots);
    try_signs(name);
    if (hole.rank == 0 && slots.empty()) {
      try_signs(tree_.add({.op = Op::power, .span = hole.span, .exponent = 2}, std::span(&name, 1)));
    }
  }

  void try_signs(ExprId value) {
    const ExprNode node = tree_[value];
    try_value(value);
    try_value(tree_.add({.op = Op::negate, .rank = node.rank, .span = node.span}, std::span(&value, 1)));
  }

  void try_value(ExprId value) {
    if (reading_.names.size() >= most_names || tried_++ >= most_candidates) return;
    Equation equation = claim_.equation;
    equation.right = replaced(tree_, equation.right, [&](ExprId each) -> std::optional<ExprId> {
      return tree_[each].symbol == reading_.symbol ? std::optional(value) : std::nullopt;
    });
    if (holds(equation)) reading_.names.push_back({value});
  }

  ExprTree& tree_;
  const Names& names_;
  const Claim& claim_;
  HoleReading& reading_;
  std::size_t tried_ = 0;
};

}  // namespace

void try_names(ExprTree& tree, const Names& names, const Claim& claim, HoleReading& reading) {
  NameTrial(tree, names, claim, reading).run();
}

}  // namespace rigor
