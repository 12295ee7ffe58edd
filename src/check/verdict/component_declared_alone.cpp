// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/component_declared_alone.h"

#include <set>

#include "check/verdict/law_diagnostic.h"

namespace rigor {

std::optional<DeclaredComponent> component_declared_alone(const Question& question) {
  const ExprTree& tree = *question.tree;
  std::set<SymbolId> reached;
  const auto reach = [&](ExprId side) {
    for (const SymbolId symbol : symbols_in(tree, side)) reached.insert(symbol);
  };
  for (const ExprId side : {question.claim.left, question.claim.right}) reach(side);
  for (const Definition& definition : question.definitions) reach(definition.body);
  for (const Equation& assumption : question.assumptions) {
    reach(assumption.left);
    reach(assumption.right);
  }
  for (const SymbolId vector : reached) {
    if (tree.symbols[vector].rank != 1 || tree.symbols[vector].per_particle) continue;
    const std::string& name = tree.symbols[vector].name;
    for (const SymbolId number : reached) {
      const Symbol& alone = tree.symbols[number];
      const bool component =
          alone.rank == 0 && alone.declared && !alone.derivation &&
          (alone.name == bare_name(name) + "_{1}" || alone.name == bare_name(name) + "_{2}" ||
           alone.name == bare_name(name) + "_{3}");
      if (component) return DeclaredComponent{alone.name, name};
    }
  }
  return std::nullopt;
}

}  // namespace rigor
