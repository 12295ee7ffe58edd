// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/average.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "elaborate/evidence/evidence.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// What all averages of a page run over: outcomes, or a state. It is not written.
SymbolId outcome_of(ExprTree& tree) {
  for (std::uint32_t k = 0; k < tree.symbols.size(); ++k) {
    const std::optional<Integral>& known = tree.symbols[SymbolId{k}].integral;
    if (known && known->average) return known->variable;
  }
  return tree.symbols.add({.name = "\\text{outcome}"});
}

/// Is its average a real number? `used`: the observables of this. Recursion: as deep as the tree, through
/// definitions.
class SelfAdjoint {
 public:
  SelfAdjoint(const Names& names, const ExprTree& tree) : names_(names), tree_(tree) {}

  bool is(ExprId id) {
    const ExprNode& node = tree_[id];
    const auto children = tree_.children(id);
    if (!has_operators(tree_, id) && !has_complex_numbers(tree_, id)) return true;
    switch (node.op) {
      case Op::symbol:
        return tree_.symbols[node.symbol].noncommuting && !tree_.symbols[node.symbol].complex &&
               is_observable(node.symbol);
      case Op::absolute:
      case Op::length:
      case Op::real_part:
      case Op::imaginary_part:
        return !has_operators(tree_, id);
      case Op::add:
      case Op::negate:
      case Op::power:
        return std::ranges::all_of(children, [&](ExprId each) { return is(each); });
      case Op::divide:
        return is(children[0]) && !has_operators(tree_, children[1]) && is(children[1]);
      case Op::multiply:
        return is_palindrome(children);
      default:
        return false;
    }
  }

  [[nodiscard]] const std::vector<SymbolId>& used() const { return used_; }

 private:
  bool is_observable(SymbolId symbol) {
    const NameKey* key = key_of(names_.symbols, symbol);
    if (key == nullptr) return false;
    if (const auto body = body_of_definition(names_.scope, symbol); body && depth_ < deepest) {
      ++depth_;
      const bool real = is(*body);
      --depth_;
      return real;
    }
    const auto& daggered = names_.symbols.evidence->daggered;
    if (daggered.contains(key->base) || daggered.contains(without_labels(key->base))) return false;
    if (std::ranges::find(used_, symbol) == used_.end()) used_.push_back(symbol);
    return true;
  }

  [[nodiscard]] bool are_adjoint(ExprId a, ExprId b) const {
    return tree_[a].op == Op::conjugate && same_expression(tree_, tree_.children(a)[0], tree_, b);
  }

  /// `AHA`, `a^\dagger a`: the same from behind. Numbers are not in the way.
  bool is_palindrome(std::span<const ExprId> children) {
    std::vector<ExprId> factors;
    for (const ExprId child : children) {
      if (!has_operators(tree_, child) && !has_complex_numbers(tree_, child)) continue;
      factors.push_back(child);
    }
    for (std::size_t k = 0, last = factors.size(); k < last; ++k) {
      const ExprId left = factors[k];
      const ExprId right = factors[last - 1 - k];
      if (are_adjoint(left, right) || are_adjoint(right, left)) continue;
      if (!same_expression(tree_, left, tree_, right) || !is(left)) return false;
    }
    return true;
  }

  static constexpr int deepest = 8;  // definitions of definitions

  const Names& names_;
  const ExprTree& tree_;
  std::vector<SymbolId> used_;
  int depth_ = 0;
};

}  // namespace

SymbolId symbol_of_average(ExprTree& tree, ExprId inside, bool complex, Span span) {
  for (std::uint32_t k = 0; k < tree.symbols.size(); ++k) {
    const std::optional<Integral>& known = tree.symbols[SymbolId{k}].integral;
    if (known && known->average && same_expression(tree, known->integrand, tree, inside)) return SymbolId{k};
  }
  const SymbolId outcome = outcome_of(tree);
  return tree.symbols.add(
      {.name = fmt::format("\\langle {}\\rangle", print_latex(tree, inside)),
       .complex = complex,
       .first_seen = span,
       .integral =
           Integral{.integrand = inside, .variable = outcome, .by = {By::letter, outcome}, .average = true}});
}

std::optional<std::vector<SymbolId>> observables_with_real_average(const Names& names, const ExprTree& tree,
                                                                   ExprId inside) {
  SelfAdjoint self_adjoint(names, tree);
  return self_adjoint.is(inside) ? std::optional(self_adjoint.used()) : std::nullopt;
}

}  // namespace rigor
