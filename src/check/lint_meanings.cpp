// SPDX-License-Identifier: GPL-3.0-or-later
// The same signs for two symbols: `r_\alpha` is the length of `\mathbf{r}_\alpha` in one place and a number
// of its own in another. Which symbol is meant was settled by a declaration or by the company it keeps; this
// only compares what was settled.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

#include "check/lint_readings.h"

namespace rigor {
namespace {

/// What the reader sees, with every particle label alike; nothing for components and derivatives.
std::optional<std::string> look_of(const WrittenSymbol& symbol) {
  if (symbol.face != Face::plain || symbol.dots > 0) return std::nullopt;
  std::string look = fmt::format("{}{}{}{}", symbol.change, static_cast<int>(symbol.accent), symbol.letter,
                                 std::string(symbol.primes, '\''));
  for (const WrittenIndex& index : symbol.lower) {
    if (index.form == IndexForm::letter || index.primes > 0) return std::nullopt;
    look += '_' + (index.form == IndexForm::greek ? "*" : index.text);
  }
  return look;
}

std::string words_of(const SymbolReading& reading) {
  switch (reading.meaning) {
    case Meaning::number:
      return "a number of its own";
    case Meaning::length:
      return fmt::format("the length of `{}`", reading.name);
    case Meaning::vector:
      return "a vector";
    case Meaning::tensor:
      break;
  }
  return "a tensor";
}

}  // namespace

Findings lint_meanings(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  const std::map<Extent, SymbolReading> readings = symbol_readings(input);
  std::map<std::string, SymbolReading> first;
  std::set<std::string> said;
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    for (const SyntaxId id : nodes_below(syntax, statement.chain->sides)) {
      if (syntax[id].kind != SyntaxKind::symbol) continue;
      const auto look = look_of(syntax.symbol(id));
      const auto reading = readings.find(extent_of(syntax[id].span));
      if (!look || reading == readings.end()) continue;
      const auto [known, fresh] = first.try_emplace(*look, reading->second);
      if (fresh || known->second.meaning == reading->second.meaning || !said.insert(*look).second) continue;
      const std::string before = words_of(known->second);
      findings.push_back(
          {{DiagnosticKind::two_meanings,
            syntax[id].span,
            fmt::format("`{}` is {} here, and {} elsewhere", input.sources.text(syntax[id].span),
                        words_of(reading->second), before),
            {{known->second.place, fmt::format("here it is {}", before)}},
            {"another letter for one of them keeps them apart"}}});
    }
  }
  return findings;
}

}  // namespace rigor
