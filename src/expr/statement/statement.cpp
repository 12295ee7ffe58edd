// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/statement.h"

#include <utility>

namespace rigor {

Equation as_equation(ExprTree& tree, const Definition& definition) {
  ExprNode node{.op = Op::symbol, .span = tree[definition.body].span, .symbol = definition.symbol};
  node.particle = definition.particle;
  std::vector<Slot> slots;
  for (const IndexId index : definition.indices) slots.push_back({0, index});
  if (slots.empty()) node.rank = static_cast<std::uint8_t>(tree.symbols[definition.symbol].rank);
  Equation equation{.left = tree.add(node, {}, slots), .right = definition.body};
  equation.indices = definition.indices;
  if (definition.particle != no_particle) equation.particles.push_back(definition.particle);
  return equation;
}

Decision proved_by(Proof proof) {
  Decision decision;
  decision.outcome = Outcome::proved;
  decision.vanishes = proof.vanishes;
  decision.route = route_of(proof);
  decision.unfolded = proof.unfolded;
  decision.assumptions = assumptions_of(proof);
  decision.proof = std::move(proof);
  return decision;
}

}  // namespace rigor
