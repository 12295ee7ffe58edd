// SPDX-License-Identifier: GPL-3.0-or-later
// A definition by the notes that no other equation of the file mentions. The result of a derivation is often
// one, so that this is off unless asked for. (A `let` that nothing uses is an error: `unused-directive`.)
#include <fmt/format.h>

#include <map>
#include <set>

#include "check/lint/lint.h"

namespace rigor {

Findings lint_definitions(const LintInput& input) {
  const ExprTree& tree = input.tree;
  std::map<SymbolId, std::size_t> mentions;  // in how many equations
  for (const StatedEquation& stated : input.stated) {
    std::set<SymbolId> symbols;
    for (const ExprId side : {stated.left, stated.right}) {
      for (const SymbolId symbol : symbols_in(tree, side)) symbols.insert(base_of(tree.symbols, symbol));
    }
    for (const SymbolId symbol : symbols) ++mentions[symbol];
  }
  Findings findings;
  for (const StatedEquation& stated : input.stated) {
    const bool defines = input.report.steps[stated.step].verdict == Verdict::definition && stated.by_notes;
    const std::vector<SymbolId> symbols = symbols_in(tree, stated.left);
    if (!defines || symbols.size() != 1 || mentions[base_of(tree.symbols, symbols[0])] > 1) continue;
    const Span left = tree[stated.left].span;
    findings.push_back({{DiagnosticKind::unused_definition,
                         left,
                         fmt::format("no other equation mentions `{}`", input.sources.text(left)),
                         {},
                         {}}});
  }
  return findings;
}

}  // namespace rigor
