// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/written_statements.h"

#include <algorithm>
#include <set>

namespace rigor {

std::vector<WrittenStatement> statements_in(const Notes& notes) {
  std::vector<WrittenStatement> statements;
  const auto take = [&](const std::vector<ParsedChain>& chains, bool displayed) {
    for (const ParsedChain& chain : chains) {
      if (chain.image == 0) statements.push_back({&chain, displayed});
    }
  };
  for (const Event& event : notes.events) {
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains, true);
    if (const auto* placed = std::get_if<PlacedDirective>(&event)) take(placed->directive.chains, false);
  }
  return statements;
}

std::vector<SyntaxId> nodes_below(const SyntaxTree& syntax, std::vector<SyntaxId> roots) {
  std::vector<SyntaxId> nodes;
  std::ranges::reverse(roots);
  while (!roots.empty()) {
    const SyntaxId id = roots.back();
    roots.pop_back();
    nodes.push_back(id);
    const auto children = syntax.children(id);
    for (auto child = children.rbegin(); child != children.rend(); ++child) roots.push_back(child->id);
  }
  return nodes;
}

std::vector<ExprId> nodes_below(const ExprTree& tree, std::vector<ExprId> roots) {
  std::vector<ExprId> nodes;
  std::set<ExprId> reached;
  std::ranges::reverse(roots);
  while (!roots.empty()) {
    const ExprId id = roots.back();
    roots.pop_back();
    if (!reached.insert(id).second) continue;
    nodes.push_back(id);
    const auto children = tree.children(id);
    for (auto child = children.rbegin(); child != children.rend(); ++child) roots.push_back(*child);
  }
  return nodes;
}

}  // namespace rigor
