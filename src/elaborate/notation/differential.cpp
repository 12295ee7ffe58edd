// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/differential.h"

#include "elaborate/notation/notations.h"
#include "elaborate/reading/change.h"
#include "elaborate/symbol/symbol.h"
#include "expr/tree/path.h"

namespace rigor {

bool reads_differentials(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const Names& names) {
  return !names.symbols.evidence->d_is_a_letter && !is_declared(names.symbols, {"d", 0, false}) &&
         relates_differentials(syntax, sides);
}

MaybeTyped differential_of(Reading& reading, SyntaxId operand, Span span, const Around& around) {
  if (!reading.rules.differentials)
    return unsupported(reading, span, "a differential by itself is not read",
                       {"it is where each term of each side has one: `dU = T\\,dS - p\\,dV`"});
  auto typed = elaborate(reading, operand, around);
  if (!typed) return typed;
  if (typed->rank > 0 || !typed->free.empty() || !typed->particles.empty())
    return unsupported(reading, span, "the differential of what is no plain number is not read");
  const SymbolId path =
      symbol_named(reading, {std::string(path_parameter), 0, false}, std::string(path_parameter), span);
  return derivative_by(reading, *std::move(typed), {By::letter, path});
}

MaybeTyped form_named(Reading& reading, SyntaxId letter, Span span, const Around& around) {
  WrittenSymbol symbol = reading.syntax.symbol(letter);
  if (symbol.face != Face::plain || !symbol.change.empty())
    return unsupported(reading, span, "a small change of this is not decided");
  symbol.change = "\\delta";
  symbol.letter_span = span;
  return elaborate_symbol(reading, symbol, span, around);
}

}  // namespace rigor
