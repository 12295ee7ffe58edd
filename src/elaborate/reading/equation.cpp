// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/equation.h"

#include <fmt/format.h>

#include <algorithm>

#include "elaborate/reading/matrix_product.h"
#include "expr/tree/state.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

const char* kind_of(const Typed& typed) {
  if (typed.layout == Layout::matrix) return "a matrix";
  if (typed.layout == Layout::triple) return "a vector of matrices";
  if (typed.layout != Layout::none) return typed.layout == Layout::row ? "a row" : "a column";
  if (typed.rank == 0) return "a scalar";
  return typed.rank == 1 ? "a vector" : "a tensor";
}

/// A row is no column; a vector of unknown layout can be either.
bool are_row_and_column(const Typed& first, const Typed& other) {
  return (first.layout == Layout::row && other.layout == Layout::column) ||
         (first.layout == Layout::column && other.layout == Layout::row);
}

/// A written 0 stands for the zero of whatever it is compared with.
ExprId zero_like(Reading& reading, const Typed& written, const Typed& other) {
  return other.rank == 0 ? written.id
                         : zero_of_rank(reading.tree, reading.tree[written.id].span, other.rank,
                                        reading.tree[other.id].axes);
}

/// `\sigma_i` or `\mathbf n\cdot\boldsymbol\sigma`, and nothing else.
bool is_one_of_triple(const ExprTree& tree, ExprId id) {
  return tree[id].op == Op::dot && tree[tree.children(id)[0]].rank == 1 &&
         tree[tree.children(id)[1]].rank == 3;
}

/// `A^2 = 1`: a multiple of the unit matrix. But `A = 1` can say of another A what number it is, and
/// `\mathbf n\cdot\boldsymbol\sigma = 1` what was measured.
Typed opposite_side(Reading& reading, const Typed& typed, const Typed& other) {
  const bool letter = reading.tree[other.id].op == Op::symbol || reading.tree[other.id].op == Op::tuple ||
                      is_one_of_triple(reading.tree, other.id);
  return letter && !typed.with_unit ? typed : beside_matrix(reading, typed, other);
}

/// `\det\sigma_i = -1`: a number without an index is meant for each of the three.
void hold_for_each(Reading& reading, Typed& typed, const Typed& other) {
  const bool letter = reading.tree[typed.id].op == Op::symbol;
  if (!reading.found.triples || letter || !typed.free.empty() || other.free.size() != 1) return;
  note(reading, fmt::format("the row holds for each `{}`", other.free[0].letter));
  typed.free = other.free;
}

/// `\sigma_i\sigma_j = -\sigma_j\sigma_i` may be meant for different indices: nothing in it tells equal ones
/// apart, as δ and ε do.
void guess_different_indices(Reading& reading, const Equation& equation) {
  if (!reading.found.triples || equation.indices.size() < 2 || reading.found.guess) return;
  const std::vector<ExprId> all = nodes_below(reading.tree, {equation.left, equation.right});
  const bool told_apart = std::ranges::any_of(
      all, [&](ExprId id) { return reading.tree[id].op == Op::delta || reading.tree[id].op == Op::epsilon; });
  if (told_apart) return;
  reading.found.guess =
      Obstacle{DiagnosticKind::ambiguous_reading,
               fmt::format("the row can be meant for all `{}` and `{}`, or for different ones",
                           reading.tree.name(equation.indices[0]), reading.tree.name(equation.indices[1])),
               {}};
}

/// Does a letter stand there as a number, m of `\cos mx`?
bool has_number(const ExprTree& tree, ExprId id, const std::string& letter) {
  return std::ranges::any_of(symbols_in(tree, id), [&](SymbolId symbol) {
    const Symbol& known = tree.symbols[symbol];
    if (known.name == letter) return true;
    return known.integral && has_number(tree, known.integral->integrand, letter);
  });
}

const char* name_of_shape(UnsizedShape shape) {
  switch (shape) {
    case UnsizedShape::number:
      return "a number";
    case UnsizedShape::matrix:
      return "a matrix";
    case UnsizedShape::column:
      return "a column";
    case UnsizedShape::row:
      return "a row";
    case UnsizedShape::none:
      break;
  }
  return "a product of rows and columns that do not fit together";
}

/// Matrices and columns of any size. A number can stand for a multiple of the unit matrix, unless matrices
/// make it: of `\det A = A` one side is meant otherwise.
bool same_shape(const Reading& reading, ExprId first, ExprId other, const char* what,
                const Mismatch& mismatch) {
  const ExprTree& tree = reading.tree;
  if (tree.is_zero_literal(first) || tree.is_zero_literal(other)) return true;
  if (!is_unsized(tree, first) && !is_unsized(tree, other)) return true;
  const UnsizedShape one = unsized_shape(tree, first);
  const UnsizedShape two = unsized_shape(tree, other);
  const auto is_plain_number = [&](ExprId id) { return !is_unsized(tree, id); };
  const bool unit = (one == UnsizedShape::matrix && is_plain_number(other)) ||
                    (two == UnsizedShape::matrix && is_plain_number(first));
  const bool term = std::string_view(what) == "term";
  const bool sum = term && (one == UnsizedShape::matrix || two == UnsizedShape::matrix) &&
                   (one == UnsizedShape::number || two == UnsizedShape::number);
  if ((one == two && one != UnsizedShape::none) || unit || sum) return true;
  mismatch.diagnostics.push_back(
      {DiagnosticKind::ambiguous_reading,
       mismatch.relation,
       fmt::format("one {} is {}, the other is {}", what, name_of_shape(two), name_of_shape(one)),
       {{tree[first].span, name_of_shape(one)}}});
  return false;
}

const char* name_of_shape(StateShape shape) {
  switch (shape) {
    case StateShape::number:
      return "a number";
    case StateShape::operators:
      return "an operator";
    case StateShape::ket:
      return "a ket";
    case StateShape::bra:
      return "a bra";
    case StateShape::none:
      break;
  }
  return "a product of kets and bras that is not read";
}

/// A ket equals a ket. A number can stand for a multiple of the unit operator.
bool same_kind_of_state(const Reading& reading, ExprId first, ExprId other, const char* what,
                        const Mismatch& mismatch) {
  const ExprTree& tree = reading.tree;
  const bool one_holds = holds_states(tree, first);
  const bool other_holds = holds_states(tree, other);
  if (!one_holds && !other_holds) return true;
  const StateShape one = state_shape(tree, first);
  const StateShape two = state_shape(tree, other);
  const bool zero = tree.is_zero_literal(first) || tree.is_zero_literal(other);
  const bool none = one == StateShape::none || two == StateShape::none;
  const auto is_unit = [](StateShape number, bool holds, StateShape of) {
    return number == StateShape::number && !holds && of == StateShape::operators;
  };
  const bool unit = is_unit(one, one_holds, two) || is_unit(two, other_holds, one);
  if (!none && (zero || one == two || unit)) return true;
  mismatch.diagnostics.push_back(
      {DiagnosticKind::ambiguous_reading,
       mismatch.relation,
       fmt::format("one {} is {}, the other is {}", what, name_of_shape(two), name_of_shape(one)),
       {{tree[first].span, name_of_shape(one)}}});
  return false;
}

/// Of δ with the numbers of states nothing is known but what the laws of a row with kets say.
void guess_numbers_of_states(Reading& reading, const Equation& equation) {
  const ExprTree& tree = reading.tree;
  if (reading.found.guess || holds_states(tree, equation.left) || holds_states(tree, equation.right)) return;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId each : symbols_in(tree, side)) {
      if (is_kronecker_of_states(tree.symbols[each]))
        reading.found.guess = Obstacle{
            DiagnosticKind::ambiguous_reading,
            fmt::format("`{}` is δ of two states, which is not decided with where no state is written",
                        tree.symbols[each].name),
            {}};
    }
  }
}

}  // namespace

bool same_type(const Reading& reading, const Typed& first, const Typed& other, const char* what,
               Mismatch mismatch) {
  const Span first_span = reading.tree[first.id].span;
  if (first.rank != other.rank && reading.found.dyad) {
    const Obstacle& guess = *reading.found.guess;
    report(mismatch.diagnostics, DiagnosticKind::ambiguous_reading, *reading.found.dyad, guess.message,
           guess.help);
    return false;
  }
  if (first.rank != other.rank || are_row_and_column(first, other)) {
    mismatch.diagnostics.push_back(
        {kind_of_mismatch(reading),
         mismatch.relation,
         fmt::format("one {} is {}, the other is {}", what, kind_of(other), kind_of(first)),
         {{first_span, kind_of(first)}}});
    return false;
  }
  if (!same_kind_of_state(reading, first.id, other.id, what, mismatch)) return false;
  if (!same_shape(reading, first.id, other.id, what, mismatch)) return false;
  if (reading.tree[first.id].axes != reading.tree[other.id].axes) {
    const bool tables = first.layout != Layout::none && other.layout != Layout::none;
    mismatch.diagnostics.push_back(
        {kind_of_mismatch(reading),
         mismatch.relation,
         tables ? fmt::format("the {}s have different numbers of rows or columns", what)
                : fmt::format("the {}s belong to different spaces", what),
         {{first_span, tables ? "of another size" : "of another space"}}});
    return false;
  }
  const auto missing = [](const auto& from, const auto& in) {
    return std::ranges::find_if(from, [&](const auto& entry) {
      return std::ranges::none_of(in, [&](const auto& old) { return old.letter == entry.letter; });
    });
  };
  const auto tell = [&](const auto& entry, const Typed& other_side) {
    const Span without = reading.tree[other_side.id].span;
    const bool shown =
        reading.letters.is_sure(entry.letter) && !has_number(reading.tree, other_side.id, entry.letter);
    if (entry.height != Height::none) {
      mismatch.diagnostics.push_back({DiagnosticKind::unsupported,
                                      entry.span,
                                      fmt::format("only one {} has the free index `{}`", what, entry.letter),
                                      {{without, fmt::format("no free `{}` here", entry.letter)}}});
      return false;
    }
    // `\sigma_i\sigma_j = i\sigma_k` is meant for three indices in their order.
    const DiagnosticKind kind = reading.found.triples ? DiagnosticKind::unsupported
                                : shown               ? DiagnosticKind::free_index_mismatch
                                                      : DiagnosticKind::ambiguous_reading;
    mismatch.diagnostics.push_back(
        {kind,
         entry.span,
         shown
             ? fmt::format("only one {} has the free index `{}`", what, entry.letter)
             : fmt::format("`{}` can be a free index, which only one {} has, or a label", entry.letter, what),
         {{without, fmt::format("no free `{}` here", entry.letter)}}});
    return false;
  };
  if (const auto extra = missing(other.free, first.free); extra != other.free.end())
    return tell(*extra, first);
  if (const auto extra = missing(first.free, other.free); extra != first.free.end())
    return tell(*extra, other);
  for (const FreeIndex& entry : other.free) {
    const auto same = std::ranges::find(first.free, entry.letter, &FreeIndex::letter);
    if (same == first.free.end() || same->height == entry.height) continue;
    const bool above = entry.height == Height::above;
    mismatch.diagnostics.push_back({DiagnosticKind::unsupported,
                                    entry.span,
                                    fmt::format("`{}` is {} in one {} and {} in the other", entry.letter,
                                                above ? "above" : "below", what, above ? "below" : "above"),
                                    {{same->span, ""}}});
    return false;
  }
  return true;
}

std::optional<Equation> equate(Reading& reading, const Typed& one, const Typed& other, Mismatch mismatch) {
  Typed left = opposite_side(reading, one, other);
  Typed right = opposite_side(reading, other, one);
  hold_for_each(reading, left, right);
  hold_for_each(reading, right, left);
  const bool left_zero = is_literal_zero(reading.tree, left);
  const bool right_zero = is_literal_zero(reading.tree, right);
  if (!left_zero && !right_zero && !same_type(reading, left, right, "side", mismatch)) return std::nullopt;
  Equation equation;
  equation.left = left_zero ? zero_like(reading, left, right) : left.id;
  equation.right = right_zero ? zero_like(reading, right, left) : right.id;
  const Typed& whole = left_zero ? right : left;
  for (const FreeIndex& free : whole.free) equation.indices.push_back(free.id);
  std::vector<FreeParticle> particles = left.particles;
  merge_free(particles, right.particles);
  for (const FreeParticle& free : particles) equation.particles.push_back(free.id);
  guess_different_indices(reading, equation);
  guess_numbers_of_states(reading, equation);
  return equation;
}

}  // namespace rigor
