// SPDX-License-Identifier: GPL-3.0-or-later
// A number and a tensor of one letter in one equation: `|I_{ij} - I\delta_{ij}| = 0`. Where the notes say
// what the number is, as in `R = R_{ii}`, it is a convention and no slip.
#include <fmt/format.h>

#include <map>
#include <set>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {
namespace {

/// Numbers that an equation says the meaning of.
std::set<SymbolId> defined_symbols(const LintInput& input) {
  std::set<SymbolId> defined;
  for (const StatedEquation& stated : input.stated) {
    if (stated.passing || input.report.steps[stated.step].verdict != Verdict::definition) continue;
    for (const SymbolId symbol : symbols_in(input.tree, stated.left)) defined.insert(symbol);
  }
  return defined;
}

}  // namespace

Findings lint_letters(const LintInput& input) {
  const ExprTree& tree = input.tree;
  const std::set<SymbolId> defined = defined_symbols(input);
  std::set<SymbolId> said;
  Findings findings;
  for (const StatedEquation& stated : input.stated) {
    if (!stated.by_notes) continue;
    std::map<std::string, ExprId> numbers;
    std::map<std::string, ExprId> tensors;
    for (const ExprId id : nodes_below(tree, {stated.left, stated.right})) {
      if (tree[id].op != Op::symbol || tree.symbols[tree[id].symbol].derivation) continue;
      const Symbol& symbol = tree.symbols[tree[id].symbol];
      if (symbol.rank == 0 && !defined.contains(tree[id].symbol)) numbers.try_emplace(symbol.name, id);
      if (symbol.rank > 1) tensors.try_emplace(symbol.name, id);
    }
    for (const auto& [name, number] : numbers) {
      const auto tensor = tensors.find(name);
      if (tensor == tensors.end() || !said.insert(tree[number].symbol).second) continue;
      findings.push_back({{DiagnosticKind::shared_letter,
                           tree[number].span,
                           fmt::format("`{}` is a number here, and a tensor with indices", name),
                           {{tree[tensor->second].span, ""}},
                           {"another letter for one of them keeps them apart"}}});
    }
  }
  return findings;
}

}  // namespace rigor
