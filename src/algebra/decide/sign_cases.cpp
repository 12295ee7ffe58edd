// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/decide/sign_cases.h"

#include <algorithm>
#include <array>
#include <set>

namespace rigor {
namespace {

constexpr std::size_t most_letters = 4;

/// All parts of the equations, and of what their letters mean.
std::vector<ExprId> parts_of(const Scope& scope, const std::vector<Equation>& equations) {
  std::vector<ExprId> roots;
  for (const Equation& each : equations) roots.insert(roots.end(), {each.left, each.right});
  for (const SymbolId symbol : reach(scope, roots).unfolded)
    roots.push_back(scope.definition_of(symbol)->body);
  return nodes_below(scope.tree(), std::move(roots));
}

/// Adds the letters that are not 0 if a product or quotient is not. Recursion: as deep as products, through
/// definitions.
void add_factors(const Scope& scope, ExprId id, std::set<SymbolId>& letters) {
  const ExprTree& tree = scope.tree();
  const ExprNode& node = tree[id];
  switch (node.op) {
    case Op::symbol:
      if (const Definition* definition = scope.definition_of(node.symbol)) {
        add_factors(scope, definition->body, letters);
      } else if (node.rank == 0 && node.slot_count == 0) {
        letters.insert(node.symbol);
      }
      break;
    case Op::multiply:
    case Op::divide:
    case Op::negate:
    case Op::root:
    case Op::power:
      for (const ExprId child : tree.children(id)) add_factors(scope, child, letters);
      break;
    default:
      break;
  }
}

}  // namespace

std::vector<std::vector<KnownSign>> sign_cases(const Scope& scope, const Attempt& attempt) {
  const ExprTree& tree = scope.tree();
  const Question& question = scope.question();
  std::vector<Equation> all{question.claim};
  for (const std::size_t position : attempt.assumptions) all.push_back(question.assumptions[position]);
  std::set<SymbolId> below_roots;
  for (const ExprId id : parts_of(scope, all)) {
    if (tree[id].op != Op::root) continue;
    const std::vector<SymbolId> inside = reach(scope, tree.children(id)).symbols;
    below_roots.insert(inside.begin(), inside.end());
  }
  // By the claim: an assumption that is not needed says nothing.
  std::set<SymbolId> divided_by;
  for (const ExprId id : parts_of(scope, {question.claim})) {
    const std::span<const ExprId> children = tree.children(id);
    if (tree[id].op == Op::divide) add_factors(scope, children[1], divided_by);
    if (tree[id].op == Op::power && tree[id].exponent < 0) add_factors(scope, children[0], divided_by);
  }
  std::vector<SymbolId> letters;
  std::ranges::copy_if(divided_by, std::back_inserter(letters), [&](SymbolId letter) {
    const Symbol& symbol = tree.symbols[letter];
    return below_roots.contains(letter) && !symbol.is_fixed() && !symbol.per_particle && !symbol.complex;
  });
  if (letters.empty() || letters.size() > most_letters) return {};
  std::vector<std::vector<KnownSign>> cases{{}};
  for (const SymbolId letter : letters) {
    std::vector<std::vector<KnownSign>> finer;
    for (const std::vector<KnownSign>& each : cases) {
      for (const bool positive : {true, false}) {
        finer.push_back(each);
        finer.back().push_back({letter, positive});
      }
    }
    cases = std::move(finer);
  }
  return cases;
}

}  // namespace rigor
