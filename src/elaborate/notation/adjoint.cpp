// SPDX-License-Identifier: GPL-3.0-or-later
// Transposes, conjugates and adjoints of matrices with known entries, and their commutators.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/product.h"
#include "elaborate/reading/triple.h"
#include "elaborate/symbol/triple_letter.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

/// Angles, energies, times: nobody has to say that they are real.
bool is_usual_real_entry(std::string_view letter) {
  static constexpr std::array<std::string_view, 31> usual{"\\theta",
                                                          "\\vartheta",
                                                          "\\varphi",
                                                          "\\phi",
                                                          "\\omega",
                                                          "\\Omega",
                                                          "\\hbar",
                                                          "\\pi",
                                                          "\\mu",
                                                          "\\lambda",
                                                          "\\tau",
                                                          "\\epsilon",
                                                          "\\varepsilon",
                                                          "\\Delta",
                                                          "\\nu",
                                                          "\\rho",
                                                          "\\kappa",
                                                          "E",
                                                          "m",
                                                          "M",
                                                          "t",
                                                          "x",
                                                          "y",
                                                          "r",
                                                          "k",
                                                          "p",
                                                          "B",
                                                          "n",
                                                          "N",
                                                          "L",
                                                          "\\ell"};
  return is_one_of(letter, usual);
}

/// A letter in it that can be a complex number, for all that the section says.
const Symbol* letter_that_may_be_complex(const Reading& reading, ExprId matrix) {
  const Names& names = reading.names;
  const Evidence& evidence = *names.symbols.evidence;
  for (const SymbolId symbol : symbols_reached(reading.tree, names.scope, {matrix})) {
    const SymbolId base = base_of(reading.tree.symbols, symbol);
    const Symbol& letter = reading.tree.symbols[base];
    const NameKey* key = key_of(names.symbols, base);
    if (key == nullptr || key->shape.any() || letter.complex || letter.is_fixed() || letter.declared ||
        definition_of(names.scope, base) != nullptr)
      continue;
    const std::string bare = without_labels(key->base);
    if (evidence.real.contains(bare) || evidence.real_parts.contains(key->base)) continue;
    if (!evidence.complex.contains(bare) && is_usual_real_entry(bare)) continue;
    return &letter;
  }
  return nullptr;
}

/// Each entry conjugated. What is not shown to be complex is real, but a conjugate says that it may not be.
MaybeTyped conjugated(Reading& reading, const Typed& matrix, Span span) {
  if (const Symbol* letter = letter_that_may_be_complex(reading, matrix.id))
    return ambiguous(
        reading, span,
        fmt::format("`{}` is conjugated here, and nothing says whether it is real", letter->name),
        {fmt::format("`rigor: scalar {0}` makes it real, `rigor: complex {0}` complex", letter->name)});
  return apply_op(reading.tree, Op::conjugate, span, matrix.rank, {matrix});
}

/// Mathematicians write a star for the adjoint; who writes a dagger does not.
bool writes_daggers(const SyntaxTree& syntax) {
  for (std::size_t k = 0; k < syntax.size(); ++k) {
    const auto id = static_cast<SyntaxId>(k);
    if (syntax[id].kind == SyntaxKind::function && syntax.text(id) == "adjoint") return true;
  }
  return false;
}

bool is_square(const ExprTree& tree, const Typed& typed) {
  return typed.layout == Layout::matrix && tree[typed.id].axes[0] == tree[typed.id].axes[1];
}

}  // namespace

MaybeTyped elaborate_transpose(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const auto inside = elaborate(reading, reading.syntax.child(id, 0), around);
  if (!inside) return inside;
  if (inside->rank == 0 && is_unsized(reading.tree, inside->id))
    return apply_op(reading.tree, Op::transpose, span, 0, {*inside});
  if (inside->layout == Layout::none || is_triple(*inside))
    return unsupported(reading, span, "a transpose is read of a matrix or column with known entries only");
  return transposed(reading.tree, *inside, span);
}

MaybeTyped elaborate_adjoint(Reading& reading, SyntaxId id, const Around& around) {
  const auto inside = elaborate(reading, reading.syntax.child(id, 0), around);
  return inside ? adjoint_of(reading, *inside, reading.syntax[id].span) : std::nullopt;
}

MaybeTyped adjoint_of(Reading& reading, const Typed& matrix, Span span) {
  const bool operators = has_operators(reading.tree, matrix.id);
  if (operators || (matrix.layout == Layout::none && matrix.rank == 0))
    return apply_op(reading.tree, Op::conjugate, span, matrix.rank, {matrix});
  if (matrix.layout == Layout::none)
    return unsupported(reading, span,
                       "an adjoint is read of an operator, and of a matrix or column with known entries");
  if (is_triple(matrix))
    return of_each_member(reading, matrix, span,
                          [&](const Typed& member) { return adjoint_of(reading, member, span); });
  const auto conjugate = conjugated(reading, matrix, span);
  return conjugate ? MaybeTyped(transposed(reading.tree, *conjugate, span)) : std::nullopt;
}

MaybeTyped conjugate_of_matrix(Reading& reading, const Typed& matrix, Span span) {
  if (!writes_daggers(reading.syntax))
    return ambiguous(reading, span, "a star on a matrix can be its conjugate or its adjoint",
                     {"notes that write `^\\dagger` for adjoints leave the star to conjugates"});
  return conjugated(reading, matrix, span);
}

namespace {

/// AB ∓ BA
MaybeTyped both_orders_of_matrices(Reading& reading, const Typed& a, const Typed& b, bool minus, Span span) {
  ExprTree& tree = reading.tree;
  if (!is_square(tree, a) || !is_square(tree, b) || tree[a.id].axes != tree[b.id].axes)
    return unsupported(reading, span,
                       fmt::format("{} is read of two square matrices of one size",
                                   minus ? "a commutator" : "an anticommutator"));
  const auto product = [&](const Typed& left, const Typed& right) {
    return product_of(reading, {{left, Joint::none, span}, {right, Joint::juxtaposed, span}}, span);
  };
  const auto there = product(a, b);
  const auto back = product(b, a);
  if (!there || !back) return std::nullopt;
  return apply_op(tree, Op::add, span, 2,
                  {*there, minus ? apply_op(tree, Op::negate, span, 2, {*back}) : *back});
}

}  // namespace

std::optional<MaybeTyped> commutator(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const std::span<const SyntaxChild> both = syntax.children(id);
  const std::uint32_t brackets = syntax[id].payload;
  if (!is_pair_in_brackets(syntax[id]) || brackets == in_poisson_brackets) return std::nullopt;
  const bool square = brackets == in_square_brackets;
  const Evidence& here = *reading.names.symbols.evidence;
  const bool matrices = std::ranges::any_of(both, [&](const SyntaxChild& child) {
    return holds_matrix_letter(syntax, child.id, here) || holds_triple(reading, child.id);
  });
  if (!matrices) return std::nullopt;
  const auto a = elaborate(reading, both[0].id, around);
  const auto b = elaborate(reading, both[1].id, around);
  if (!a || !b) return MaybeTyped{};
  const Span span = syntax[id].span;
  ExprTree& tree = reading.tree;
  if (is_triple(*a) != is_triple(*b) && (is_square(tree, *a) || is_square(tree, *b)))
    return of_each_member(reading, is_triple(*a) ? *a : *b, span, [&](const Typed& member) {
      return both_orders_of_matrices(reading, is_triple(*a) ? member : *a, is_triple(*a) ? *b : member,
                                     square, span);
    });
  return both_orders_of_matrices(reading, *a, *b, square, span);
}

}  // namespace rigor
