// SPDX-License-Identifier: GPL-3.0-or-later
// The same signs for two symbols: `r_\alpha` is the length of `\mathbf{r}_\alpha` in one place and a number
// of its own in another. Which symbol is meant was settled by a declaration or by the company it keeps; this
// only compares what was settled. And the letter of a length for something else that is made of the vector:
// `r_\alpha = |\mathbf{n}\times\mathbf{r}_\alpha|`.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "check/lint/lint_readings.h"

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

std::string said_of(const SymbolReading& reading) {
  switch (reading.meaning) {
    case ReadAs::number:
      return "a number of its own";
    case ReadAs::length:
      return fmt::format("the length of `{}`", reading.name);
    case ReadAs::vector:
      return "a vector";
    case ReadAs::tensor:
      break;
  }
  return "a tensor";
}

/// `v` of `\mathbf{v}`, `\hat{v}` and `\hat{\mathbf{v}}`.
std::string_view letter_of(std::string_view name) {
  const auto open = name.rfind('{');
  if (open == std::string_view::npos) return name;
  return name.substr(open + 1, name.find('}', open) - open - 1);
}

/// Does a unit vector of the same letter stand here? Perhaps it is the vector's own direction.
bool has_direction(const ExprTree& tree, ExprId root, SymbolId vector) {
  const std::vector<SymbolId> symbols = symbols_in(tree, root);
  return std::ranges::any_of(symbols, [&](SymbolId other) {
    return other != vector && tree.symbols[other].unit &&
           letter_of(tree.symbols[other].name) == letter_of(tree.symbols[vector].name);
  });
}

/// Does a vector itself stand here, other than by its length?
bool mentions(const ExprTree& tree, ExprId root, SymbolId vector) {
  std::set<ExprId> in_lengths;
  for (const ExprId id : nodes_below(tree, {root})) {  // parents first
    if (tree[id].op == Op::length && tree[tree.children(id)[0]].span == tree[id].span)
      in_lengths.insert(tree.children(id)[0]);
    const bool whole = tree[id].op == Op::symbol && tree[id].symbol == vector && tree[id].slot_count == 0;
    if (whole && !in_lengths.contains(id)) return true;
  }
  return false;
}

/// A length that is set equal to something else made of its vector.
Findings lint_other_lengths(const LintInput& input) {
  const ExprTree& tree = input.tree;
  Findings findings;
  for (const StatedEquation& stated : input.stated) {
    const Step& step = input.report.steps[stated.step];
    const bool open = step.verdict == Verdict::law || step.verdict == Verdict::undecided ||
                      step.verdict == Verdict::refuted;
    const bool length = tree[stated.left].op == Op::length && stated.is_equation();
    if (!stated.by_notes || !open || step.expected_refuted || !length) continue;
    const ExprId vector = tree.children(stated.left)[0];
    const Span span = tree[stated.left].span;
    const bool plain_letter = tree[vector].op == Op::symbol && tree[vector].span == span;
    if (!plain_letter || !mentions(tree, stated.right, tree[vector].symbol)) continue;
    if (has_direction(tree, stated.right, tree[vector].symbol)) continue;
    findings.push_back(
        {{DiagnosticKind::two_meanings,
          span,
          fmt::format("`{}` is the length of `{}`, but is set equal to something else made of it",
                      input.sources.text(span), tree.symbols[tree[vector].symbol].name),
          {{tree[stated.right].span, ""}},
          {"another letter for it, or `where … := …`, keeps them apart"}}});
  }
  return findings;
}

}  // namespace

Findings lint_meanings(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  const std::map<Extent, SymbolReading> readings = symbol_readings(input);
  std::map<std::string, SymbolReading> first;
  std::set<std::string> said;
  Findings findings = lint_other_lengths(input);
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    for (const SyntaxId id : nodes_below(syntax, statement.chain->sides)) {
      if (syntax[id].kind != SyntaxKind::symbol) continue;
      const auto look = look_of(syntax.symbol(id));
      const auto reading = readings.find(extent_of(syntax[id].span));
      if (!look || reading == readings.end()) continue;
      const auto [known, fresh] = first.try_emplace(*look, reading->second);
      if (fresh || known->second.meaning == reading->second.meaning || !said.insert(*look).second) continue;
      const std::string before = said_of(known->second);
      findings.push_back({{DiagnosticKind::two_meanings,
                           syntax[id].span,
                           fmt::format("`{}` is {} here, and {} elsewhere",
                                       input.sources.text(syntax[id].span), said_of(reading->second), before),
                           {{known->second.place, fmt::format("here it is {}", before)}},
                           {"another letter for one of them keeps them apart"}}});
    }
  }
  return findings;
}

}  // namespace rigor
