// SPDX-License-Identifier: GPL-3.0-or-later
// A vector that is set like a number, in notes that set others bold or under an arrow:
// `\delta\theta\times\mathbf{A}`. Notes without any bold letter are consistent.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "check/lint/lint_readings.h"

namespace rigor {
namespace {

bool is_plain(const WrittenSymbol& symbol) {
  const bool primed_index =
      std::ranges::any_of(symbol.lower, [](const WrittenIndex& index) { return index.primes > 0; });
  return symbol.face == Face::plain && symbol.accent == Accent::none && !primed_index;
}

}  // namespace

Findings lint_faces(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  std::vector<SyntaxId> symbols;  // of the displays
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    if (!statement.displayed) continue;
    for (const SyntaxId id : nodes_below(syntax, statement.chain->sides)) {
      if (syntax[id].kind == SyntaxKind::symbol) symbols.push_back(id);
    }
  }
  const auto bold = std::ranges::find_if(symbols, [&](SyntaxId id) {
    return syntax.symbol(id).face == Face::vector && syntax.symbol(id).letter != "\\nabla";
  });
  Findings findings;
  if (bold == symbols.end()) return findings;
  const std::map<Extent, SymbolReading> readings = symbol_readings(input);
  std::set<SymbolId> said;
  for (const SyntaxId id : symbols) {
    const Span span = syntax[id].span;
    const auto reading = readings.find(extent_of(span));
    const bool vector = reading != readings.end() && reading->second.meaning == ReadAs::vector;
    if (!vector || !is_plain(syntax.symbol(id))) continue;
    const Symbol& symbol = input.tree.symbols[reading->second.symbol];
    if (symbol.rank > 0 && symbol.axes[0].id == space_of_columns) continue;  // a column of numbers
    if (!said.insert(base_of(input.tree.symbols, reading->second.symbol)).second) continue;
    findings.push_back({{DiagnosticKind::plain_vector,
                         span,
                         fmt::format("`{}` is a vector but is not set as one, unlike `{}`",
                                     input.sources.text(span), input.sources.text(syntax[*bold].span)),
                         {},
                         {"set the letter bold, or put an arrow on it"}}});
  }
  return findings;
}

}  // namespace rigor
