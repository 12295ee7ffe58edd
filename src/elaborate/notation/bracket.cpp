// SPDX-License-Identifier: GPL-3.0-or-later
// Bars and brackets with subscripts.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/derivative.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/summation.h"
#include "elaborate/symbol/axes.h"
#include "expr/tree/state.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

/// Is there a symbol with two subscripts of its own?
bool names_a_tensor(const SyntaxTree& syntax, SyntaxId id) {
  return std::ranges::any_of(nodes_below(syntax, {id}), [&](SyntaxId each) {
    return syntax[each].kind == SyntaxKind::component ||
           (syntax[each].kind == SyntaxKind::symbol && syntax.symbol(each).lower.size() > 1);
  });
}

/// `(AB)_{ij}`, where `A_{ij}` occurs in the notes.
bool is_matrix_product(const Reading& reading, SyntaxId id) {
  return std::ranges::any_of(nodes_below(reading.syntax, {id}), [&](SyntaxId each) {
    return reading.syntax[each].kind == SyntaxKind::symbol &&
           reading.names.symbols.sightings->indexed.contains({reading.syntax.symbol(each).letter, 2, false});
  });
}

bool is_derivative_in_bracket(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  return syntax[id].kind == SyntaxKind::derivative;
}

const Frame* frame_of(const Names& names, const std::string& label) {
  for (const Frame& frame : *names.scope.frames) {
    if (frame.rotating == label || frame.fixed == label) return &frame;
  }
  return nullptr;
}

/// √(xᵀx)
MaybeTyped bars_of_unsized(Reading& reading, const Typed& inside, bool norm, Span span) {
  ExprTree& tree = reading.tree;
  const UnsizedShape shape = unsized_shape(tree, inside.id);
  if (shape == UnsizedShape::number && !norm) return apply_op(tree, Op::absolute, span, 0, {inside});
  if (shape != UnsizedShape::column)
    return unsupported(reading, span,
                       "bars are read around columns and numbers that matrices make, and not around matrices",
                       {"`\\det` is a determinant"});
  const Typed row = apply_op(tree, Op::transpose, span, 0, {inside});
  return apply_op(tree, Op::root, span, 0, {apply_op(tree, Op::multiply, span, 0, {row, inside})});
}

/// √⟨a|a⟩, and |⟨a|b⟩|
MaybeTyped bars_of_states(Reading& reading, const Typed& inside, bool norm, Span span) {
  ExprTree& tree = reading.tree;
  const StateShape shape = state_shape(tree, inside.id);
  if (shape == StateShape::number && !norm) return apply_op(tree, Op::absolute, span, 0, {inside});
  if (shape != StateShape::ket)
    return unsupported(reading, span, "bars are read around kets and around numbers that states make");
  const Typed bra = apply_op(tree, Op::conjugate, span, 0, {inside});
  return apply_op(tree, Op::root, span, 0, {apply_op(tree, Op::multiply, span, 0, {bra, inside})});
}

}  // namespace

MaybeTyped elaborate_bars(Reading& reading, SyntaxId id, const Around& around) {
  const bool norm = reading.syntax[id].kind == SyntaxKind::norm;
  const Span span = reading.syntax[id].span;
  const SyntaxId part = reading.syntax.child(id, 0);
  const auto inside = elaborate(reading, part, around);
  if (!inside) return std::nullopt;
  if (inside->rank == 1) return apply_op(reading.tree, Op::length, span, 0, {*inside});
  if (inside->rank > 1)
    return norm ? unsupported(reading, span, "the norm of a tensor is not decided")
                : determinant_of(reading, id, *inside, span, around);
  if (is_unsized(reading.tree, inside->id)) return bars_of_unsized(reading, *inside, norm, span);
  if (holds_states(reading.tree, inside->id)) return bars_of_states(reading, *inside, norm, span);
  if (norm) return wrong_rank(reading, span, "a norm of a scalar", {"`|…|` is the absolute value"});
  if (inside->free.size() == 2) {
    if (names_a_tensor(reading.syntax, part)) return determinant_of(reading, part, *inside, span, around);
    return ambiguous(reading, span,
                     "the bars can mean a determinant of what has two free indices, or an absolute value",
                     {"`\\det` is a determinant"});
  }
  if (inside->free.size() > 2)
    return unsupported(reading, span, "bars around a quantity with more than two free indices are not read");
  return apply_op(reading.tree, Op::absolute, span, 0, {*inside});
}

MaybeTyped elaborate_component(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const SyntaxId part = reading.syntax.child(id, 0);
  const std::vector<WrittenIndex>& axes = reading.syntax.indices(id);
  std::string label;
  for (const WrittenIndex& axis : axes) label += axis.text;
  if (const Frame* frame = frame_of(reading.names, label))
    return frame_derivative(reading, part, *frame, label == frame->fixed, around);
  if (is_derivative_in_bracket(reading.syntax, part) && axes.size() == 1 &&
      axes[0].form != IndexForm::digit &&
      (may_hold_by_name(reading, part) || !reading.letters.is_index(axes[0].text)))
    return held_derivative(reading, part, axes[0], around);
  const auto base = elaborate(reading, part, around);
  if (!base) return std::nullopt;
  for (const WrittenIndex& axis : axes) {
    const bool letter = axis.form == IndexForm::letter &&
                        (reading.letters.is_index(axis.text) || axis_of_letter(axis.text) != 0);
    if (axis.form != IndexForm::digit && !letter) {
      return unsupported(reading, axis.span,
                         fmt::format("the label `{}` on a bracket is not read yet", axis.text));
    }
  }
  if (static_cast<int>(axes.size()) != base->rank) {
    if (base->rank == 0 && is_matrix_product(reading, part)) {
      return ambiguous(
          reading, span,
          "these letters have two indices elsewhere but none here: a product of matrices is not read");
    }
    const char* what = base->rank == 0 ? "a scalar has no components"
                                       : "the subscript and the bracket have different numbers of indices";
    return wrong_rank(reading, span, what);
  }
  if (any_primed(axes)) return along_axes(reading, *base, axes, span, around);
  const auto written = subscript(reading, axes, span, around);
  if (!written) return std::nullopt;
  for (std::size_t k = 0; k < written->slots.size(); ++k) {
    const Space of = reading.tree[base->id].axes[static_cast<int>(k)];
    const Slot& slot = written->slots[k];
    const bool fits = slot.axis != 0 ? slot.axis <= of.dimension : reading.tree.space(slot.variable) == of;
    if (!fits)
      return unsupported(
          reading, axes[k].span,
          fmt::format("the index `{}` does not count {} rows or columns", axes[k].text, of.dimension));
  }
  auto letters = contraction_of(reading, {*base, {.free = written->free}});
  if (!letters) return std::nullopt;
  Typed typed{.particles = base->particles};
  typed.id = reading.tree.add({.op = Op::component, .span = span}, std::span(&base->id, 1), written->slots);
  return summed(reading.tree, std::move(typed), *std::move(letters));
}

}  // namespace rigor
