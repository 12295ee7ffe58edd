// SPDX-License-Identifier: GPL-3.0-or-later
// Commutators and anticommutators, kets and bras. Which letters are operators the section shows
// (`evidence/operator_letters.cpp`); where it does not, a pair in brackets is not understood.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "elaborate/notation/notations.h"
#include "elaborate/reading/product.h"
#include "expr/print/print_latex.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

std::string what_a_pair_can_be(std::uint32_t brackets) {
  if (brackets == in_square_brackets) return "a commutator or a pair such as an interval";
  return "an anticommutator, a Poisson bracket or a set";
}

/// AB ∓ BA, with repeated indices summed as in any product.
MaybeTyped both_orders(Reading& reading, const Typed& left, const Typed& right, bool minus, Span span) {
  const auto product = [&](const Typed& first, const Typed& second) {
    return product_of(reading, {{first, Joint::none, span}, {second, Joint::juxtaposed, span}}, span);
  };
  const auto there = product(left, right);
  auto back = there ? product(right, left) : std::nullopt;
  if (!back) return std::nullopt;
  if (minus) back = apply_op(reading.tree, Op::negate, span, back->rank, {*back});
  return apply_op(reading.tree, Op::add, span, there->rank, {*there, *back});
}

}  // namespace

MaybeTyped elaborate_pair(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxNode node = reading.syntax[id];
  const auto left = elaborate(reading, reading.syntax.child(id, 0), around);
  const auto right = elaborate(reading, reading.syntax.child(id, 1), around);
  if (!left || !right) return std::nullopt;
  const bool square = node.payload == in_square_brackets;
  const Evidence& evidence = *reading.names.symbols.evidence;
  if (node.payload == in_poisson_brackets || (!square && evidence.speaks_of_poisson))
    return unsupported(reading, node.span, "Poisson brackets are not decided yet");
  for (const Typed* each : {&*left, &*right}) {
    if (has_operators(reading.tree, each->id)) continue;
    return ambiguous(reading, node.span,
                     fmt::format("this can be {}; nothing here shows that `{}` is an operator",
                                 what_a_pair_can_be(node.payload), print_latex(reading.tree, each->id)),
                     {"words such as \"the operators $A$ and $B$\" or \"commutator\" show what it is"});
  }
  if (left->rank != 0 || right->rank != 0)
    return unsupported(reading, node.span, "a commutator with a vector is not read; write its components");
  return both_orders(reading, *left, *right, square, node.span);
}

MaybeTyped elaborate_state(Reading& reading, SyntaxId id) {
  const Span span = reading.syntax[id].span;
  const SymbolId ket =
      symbol_of_ket(reading.tree, label_of(reading.syntax.text(reading.syntax.child(id, 0))), span);
  const Typed typed{.id = reading.tree.add({.op = Op::symbol, .span = span, .symbol = ket})};
  if (reading.syntax.text(id) == "ket") return typed;
  return apply_op(reading.tree, Op::conjugate, span, 0, {typed});
}

}  // namespace rigor
