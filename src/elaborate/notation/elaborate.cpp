// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/elaborate.h"

#include <fmt/format.h>

#include <utility>

#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/derivative.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/product.h"
#include "elaborate/symbol/symbol.h"
#include "elaborate/symbol/triple_letter.h"

namespace rigor {
namespace {

MaybeTyped elaborate_number(Reading& reading, SyntaxId id) {
  const Span span = reading.syntax[id].span;
  const std::string& digits = reading.syntax.text(id);
  if (digits.size() > 300) return unsupported(reading, span, "a number of more than 300 digits is not read");
  return Typed{.id = reading.tree.add_number(span, digits)};
}

MaybeTyped elaborate_fraction(Reading& reading, SyntaxId id, const Around& around) {
  const auto dividend = elaborate(reading, reading.syntax.child(id, 0), around);
  const auto divisor = elaborate(reading, reading.syntax.child(id, 1), around);
  if (!dividend || !divisor) return std::nullopt;
  return divide(reading, *dividend, *divisor, reading.syntax[id].span);
}

/// Words in a bracket may say anything about what is next to them.
MaybeTyped elaborate_group(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  for (const SyntaxChild& words : syntax.children(id).subspan(1)) {
    if (syntax[words.id].kind == SyntaxKind::opaque) reading.found.guess = syntax.obstacle(words.id);
  }
  return elaborate(reading, syntax.child(id, 0), around);
}

MaybeTyped elaborate_kind(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  switch (syntax[id].kind) {
    case SyntaxKind::number:
      return elaborate_number(reading, id);
    case SyntaxKind::symbol:
      if (const auto variable = variable_of_primes(syntax.symbol(id), *reading.names.symbols.evidence)) {
        const auto defined = variables_of_definition(reading.names, syntax.symbol(id));
        const std::string& by = defined.size() == 1 ? defined.front() : *variable;  // U'(R) of `U(r) = …`
        return primed_derivative(reading, syntax.symbol(id), by, span, around);
      }
      return elaborate_symbol(reading, syntax.symbol(id), span, around);
    case SyntaxKind::sum:
      return elaborate_sum(reading, id, around);
    case SyntaxKind::term:
      return elaborate_term(reading, id, around);
    case SyntaxKind::fraction:
      return elaborate_fraction(reading, id, around);
    case SyntaxKind::root:
      return elaborate_root(reading, id, around);
    case SyntaxKind::power:
      return elaborate_power(reading, id, around);
    case SyntaxKind::component:
      return elaborate_component(reading, id, around);
    case SyntaxKind::group:
      return elaborate_group(reading, id, around);
    case SyntaxKind::bars:
    case SyntaxKind::norm:
      return elaborate_bars(reading, id, around);
    case SyntaxKind::tuple:
      return elaborate_tuple(reading, id, around);
    case SyntaxKind::matrix:
      return elaborate_matrix(reading, id, around);
    case SyntaxKind::determinant:
      return elaborate_determinant(reading, id, around);
    case SyntaxKind::big_sum:
      return elaborate_big_sum(reading, id, around);
    case SyntaxKind::cases:
      return elaborate_cases(reading, id, around);
    case SyntaxKind::derivative:
      if (holds_triple(reading, id))
        return unsupported(reading, span, "a derivative of matrices that come as a triple is not decided");
      return elaborate_derivative(reading, id, around);
    case SyntaxKind::function:
      return elaborate_function(reading, id, around);
    case SyntaxKind::integral:
      return elaborate_integral(reading, id, around);
    case SyntaxKind::line_integral:
      return elaborate_line_integral(reading, id, around);
    case SyntaxKind::between:
      return elaborate_between(reading, id, around);
    case SyntaxKind::unit:
      return elaborate_unit(reading, id, around);
    case SyntaxKind::text:
      return unsupported(reading, span, fmt::format("the words `{}` stand for a quantity", syntax.text(id)));
    case SyntaxKind::opaque:
      return fail(reading, span, syntax.obstacle(id));
  }
  return std::nullopt;
}

}  // namespace

MaybeTyped elaborate(Reading& reading, SyntaxId id, const Around& around) {
  auto typed = elaborate_kind(reading, id, around);
  std::optional<std::string>& exceeded = reading.derivatives.budget.exceeded;
  if (!exceeded) return typed;
  return unsupported(reading, reading.syntax[id].span, *std::exchange(exceeded, std::nullopt));
}

}  // namespace rigor
