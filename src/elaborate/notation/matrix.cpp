// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/triple.h"
#include "elaborate/symbol/named_symbol.h"
#include "expr/tree/state.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

/// `\det A` where A_{ij} is a tensor.
MaybeTyped whole_tensor(Reading& reading, SyntaxId id, const Around& around) {
  if (reading.syntax[id].kind != SyntaxKind::symbol) return std::nullopt;
  const WrittenSymbol& written = reading.syntax.symbol(id);
  if (!is_undecorated(written) || !written.lower.empty() ||
      is_matrix_letter(written, *reading.names.symbols.evidence))
    return std::nullopt;
  const bool tensor = is_known(reading.names, written.letter, 2, false) &&
                      !is_declared(reading.names.symbols, {written.letter, 0, false});
  if (!tensor) return std::nullopt;
  const WrittenName name{.base = written.letter, .axes = {}, .particles = {}};
  return named_symbol(reading, {written, name, reading.syntax[id].span, around}, written.letter, 2);
}

}  // namespace

namespace {

/// The entries at some places, which are plain numbers.
std::optional<std::vector<Typed>> entries_of(Reading& reading, std::span<const SyntaxChild> children,
                                             const Around& around) {
  std::vector<Typed> entries;
  for (const SyntaxChild& child : children) {
    auto entry = elaborate(reading, child.id, around);
    if (!entry) return std::nullopt;
    const Span span = reading.syntax[child.id].span;
    if (entry->rank != 0)
      return unsupported(reading, span,
                         "a matrix, a column or a vector inside brackets is not read; write its entries out");
    if (!entry->free.empty())
      return unsupported(reading, span, "a free index inside a matrix or tuple is not decided");
    if (is_unsized(reading.tree, entry->id) && unsized_shape(reading.tree, entry->id) != UnsizedShape::number)
      return unsupported(reading, span, "a matrix of matrices is not read; write its entries out");
    if (holds_states(reading.tree, entry->id))
      return unsupported(reading, span, "a matrix or column of what states make is not decided");
    const bool block = reading.names.symbols.evidence->unsized.speaks_of_blocks &&
                       reading.syntax[child.id].kind == SyntaxKind::symbol &&
                       is_capital_letter(reading.syntax.symbol(child.id).letter);
    if (block)
      return ambiguous(reading, span, "this entry can be a matrix, of which a block is made, or a number");
    entry->with_unit.reset();
    entries.push_back(*std::move(entry));
  }
  return entries;
}

}  // namespace

namespace {

/// Are all letters below of this list, and is there one?
template <class List>
bool has_only(const SyntaxTree& syntax, SyntaxId id, const List& letters) {
  bool any = false;
  for (const SyntaxId each : nodes_below(syntax, {id})) {
    if (syntax[each].kind != SyntaxKind::symbol) continue;
    if (!is_one_of(syntax.symbol(each).letter, letters)) return false;
    any = true;
  }
  return any;
}

/// In the first row 1, 2, …, and each of them once in the second.
bool is_permutation(const SyntaxTree& syntax, SyntaxId id, MatrixShape shape) {
  if (shape.rows != 2 || shape.columns < 2) return false;
  std::set<int> below;
  for (int column = 0; column < shape.columns; ++column) {
    const auto above = whole_number(syntax, syntax.child(id, static_cast<std::size_t>(column)));
    const auto image =
        whole_number(syntax, syntax.child(id, static_cast<std::size_t>(shape.columns + column)));
    if (above != column + 1 || !image || *image < 1 || *image > shape.columns) return false;
    below.insert(*image);
  }
  return below.size() == shape.columns;
}

/// What else the brackets can mean: `\begin{pmatrix} n \\ k\end{pmatrix}` is mostly no column.
std::optional<std::string> other_meaning(const Reading& reading, SyntaxId id, MatrixShape shape) {
  static constexpr std::array<std::string_view, 10> whole{"i", "j", "k", "l", "m", "n", "r", "N", "K", "M"};
  static constexpr std::array<std::string_view, 12> momenta{"j", "J", "l", "L", "m",    "M",
                                                            "k", "s", "S", "n", "\\mu", "\\ell"};
  const SyntaxTree& syntax = reading.syntax;
  const bool imaginary = std::ranges::any_of(nodes_below(syntax, {id}), [&](SyntaxId each) {
    return syntax[each].kind == SyntaxKind::symbol && may_be_imaginary_unit(syntax.symbol(each)) &&
           reading.names.symbols.evidence->imaginary_units.contains(syntax.symbol(each).letter);
  });
  if (imaginary) return std::nullopt;
  if (shape == MatrixShape{2, 1} && has_only(syntax, id, whole))
    return "two whole numbers in brackets can be a column or a binomial coefficient";
  if (shape == MatrixShape{2, 3} && has_only(syntax, id, momenta))
    return "these brackets can be a matrix or a symbol of coupled angular momenta";
  const bool group = shape.columns > 2 || reading.names.symbols.evidence->order_in_heading;
  if (group && is_permutation(syntax, id, shape)) return "these brackets can be a matrix or a permutation";
  return std::nullopt;
}

}  // namespace

namespace {

/// `(ct, x, y, z)`, and `(E/c, \mathbf p)`: a number and a vector.
std::optional<MaybeTyped> tuple_of_event(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxNode& node = reading.syntax[id];
  const bool pair = node.count == 2 && reading.names.symbols.evidence->space_time.shown;
  const bool four = node.count == 4 && reading.names.symbols.evidence->space_time.shown;
  if ((!pair && !four) || is_pair_in_brackets(node) || node.payload != 0) return std::nullopt;
  std::vector<Typed> entries;
  if (four) {
    auto read = entries_of(reading, reading.syntax.children(id), around);
    if (!read) return MaybeTyped();
    entries = *std::move(read);
  } else {
    const auto time = elaborate(reading, reading.syntax.child(id, 0), around);
    const auto space = elaborate(reading, reading.syntax.child(id, 1), around);
    if (!time || !space) return MaybeTyped();
    const bool vector = time->rank == 0 && space->rank == 1 && time->free.empty() && space->free.empty() &&
                        reading.tree[space->id].axes[0] == common_space;
    if (!vector)
      return unsupported(reading, node.span, "of two entries, the first is a number and the second a vector");
    entries.push_back(*time);
    for (std::uint8_t axis = 1; axis <= 3; ++axis) {
      const Slot slot{axis, {}};
      Typed entry{.particles = space->particles};
      entry.id = component_of(reading.tree, space->id, std::span(&slot, 1));
      entries.push_back(std::move(entry));
    }
  }
  return tuple_of(reading.tree, space_time, node.span, entries);
}

}  // namespace

MaybeTyped elaborate_tuple(Reading& reading, SyntaxId id, const Around& around) {
  if (auto matrix = commutator(reading, id, around)) return *std::move(matrix);
  const Span span = reading.syntax[id].span;
  const MatrixShape shape = written_shape(reading.syntax, id);
  const std::size_t count = reading.syntax[id].count;
  if (auto event = tuple_of_event(reading, id, around)) return *std::move(event);
  if (const auto other = other_meaning(reading, id, shape)) return ambiguous(reading, span, *other);
  const bool table = shape.any();
  const bool in_plane = !table && space_of(reading.names.symbols).dimension == 2;
  if (is_pair_in_brackets(reading.syntax[id]) && !in_plane) return elaborate_pair(reading, id, around);
  if (!table && reading.syntax[id].payload != 0 && !is_pair_in_brackets(reading.syntax[id]))
    return unsupported(reading, span, fmt::format("a column or row of two to {} entries is read", most_rows));
  const Space space =
      table ? column_space(reading.names.symbols, static_cast<int>(count)) : use_space(reading);
  if (table && space == space_of(reading.names.symbols)) use_space(reading);
  if (count != space.dimension)
    return unsupported(reading, span,
                       space == common_space
                           ? "only tuples of three components are read"
                           : fmt::format("a vector of this space has {} components", space.dimension));
  const auto entries = entries_of(reading, reading.syntax.children(id), around);
  if (!entries) return std::nullopt;
  Typed tuple = tuple_of(reading.tree, space, span, *entries);
  if (table) tuple.layout = shape.columns == 1 ? Layout::column : Layout::row;
  reading.found.matrices = reading.found.matrices || (table && space != common_space);
  return tuple;
}

MaybeTyped elaborate_matrix(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const MatrixShape shape = written_shape(reading.syntax, id);
  if (!shape.any())
    return unsupported(reading, span,
                       fmt::format("a matrix of more than {} rows or columns is not read", most_rows));
  if (const auto other = other_meaning(reading, id, shape)) return ambiguous(reading, span, *other);
  reading.found.matrices = true;
  const Symbols& symbols = reading.names.symbols;
  const Space columns = column_space(symbols, shape.columns);
  const Space lines = column_space(symbols, shape.rows);
  if (columns == space_of(symbols) || lines == space_of(symbols)) use_space(reading);
  std::vector<Typed> rows;
  for (std::size_t row = 0; row < shape.rows; ++row) {
    const auto children = reading.syntax.children(id).subspan(row * shape.columns, shape.columns);
    const auto entries = entries_of(reading, children, around);
    if (!entries) return std::nullopt;
    rows.push_back(tuple_of(reading.tree, columns, span, *entries));
  }
  Typed matrix = tuple_of(reading.tree, lines, span, rows);
  matrix.layout = Layout::matrix;
  return matrix;
}

namespace {

/// Each entry occurs in several products, so a letter's place in them is not that of the summation
/// convention.
MaybeTyped letters_of(Reading& reading, const std::vector<Typed>& entries, Span span) {
  Typed letters;
  for (const Typed& entry : entries) merge_letters(letters, entry);
  for (const FreeIndex& bound : letters.bound) {
    const bool free_too =
        std::ranges::any_of(letters.free, [&](const FreeIndex& free) { return free.letter == bound.letter; });
    if (free_too) {
      return unsupported(
          reading, span,
          fmt::format("`{}` is summed in one entry of the determinant and free in another", bound.letter));
    }
  }
  return letters;
}

MaybeTyped determinant_of_numbers(Reading& reading, const std::vector<Typed>& entries, Span span) {
  auto letters = letters_of(reading, entries, span);
  std::vector<ExprId> numbers;
  for (const Typed& entry : entries) numbers.push_back(entry.id);
  const auto value = letters ? determinant_of_entries(reading, numbers, span) : std::nullopt;
  if (!value) return std::nullopt;
  letters->id = value->id;
  return letters;
}

}  // namespace

MaybeTyped elaborate_determinant(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const std::size_t columns = reading.syntax[id].payload;
  if (reading.syntax[id].count != columns * columns || columns > most_rows)
    return unsupported(reading, span,
                       fmt::format("a determinant has as many rows as columns, up to {}", most_rows));
  if (columns != 3) {
    const auto numbers = entries_of(reading, reading.syntax.children(id), around);
    return numbers ? determinant_of_numbers(reading, *numbers, span) : std::nullopt;
  }
  if (space_of(reading.names.symbols) != common_space)
    return unsupported(reading, span, "a determinant of three rows is read in three dimensions only");
  std::vector<Typed> entries;
  for (std::size_t k = 0; k < 9; ++k) {
    auto entry = elaborate(reading, reading.syntax.child(id, k), around);
    if (!entry) return std::nullopt;
    if (entry->rank > 1) return unsupported(reading, span, "an entry of this determinant is a tensor");
    if (entry->rank == 1 && k >= 3)
      return unsupported(reading, span, "vectors are read in the first row of a determinant only");
    entries.push_back(*std::move(entry));
    if (k < 3 && entries[k].rank != entries[0].rank)
      return wrong_rank(reading, span, "the first row mixes scalars and vectors");
  }
  if (!letters_of(reading, entries, span)) return std::nullopt;
  return apply_op(reading.tree, Op::determinant, span, entries[0].rank, entries);
}

namespace {

MaybeTyped determinant_of_matrix(Reading& reading, const Typed& matrix, Span span) {
  const std::vector<ExprId> entries = square_entries(reading.tree, matrix);
  if (entries.empty()) return unsupported(reading, span, "only square matrices have a determinant");
  auto value = determinant_of_entries(reading, entries, span);
  if (value) merge_letters(*value, matrix);
  return value;
}

}  // namespace

MaybeTyped determinant_of(Reading& reading, SyntaxId id, const Typed& inside, Span span,
                          const Around& around) {
  if (inside.layout == Layout::matrix) return determinant_of_matrix(reading, inside, span);
  if (inside.rank != 2 && !(inside.rank == 0 && inside.free.size() == 2))
    return unsupported(reading, span, "a determinant is read of a second-rank tensor only");
  if (space_of(reading.names.symbols) != common_space)
    return unsupported(reading, span, "a determinant is read in three dimensions only");
  std::vector<ExprId> entries;
  for (std::uint8_t row = 1; row <= 3; ++row) {
    for (std::uint8_t column = 1; column <= 3; ++column) {
      if (inside.rank == 2) {
        const std::array slots{Slot{row, {}}, Slot{column, {}}};
        entries.push_back(component_of(reading.tree, inside.id, slots));
        continue;
      }
      Around at_entry = around;
      at_entry.axes[inside.free[0].letter] = row;
      at_entry.axes[inside.free[1].letter] = column;
      const auto entry = elaborate(reading, id, at_entry);
      if (!entry) break;
      entries.push_back(entry->id);
    }
  }
  if (entries.size() != 9) return std::nullopt;
  Typed typed{.particles = inside.particles};
  if (inside.rank == 2) typed.free = inside.free;
  typed.id = reading.tree.add({.op = Op::determinant, .span = span}, entries);
  return typed;
}

namespace {

/// The sum of the diagonal.
MaybeTyped trace_of(Reading& reading, const Typed& inside, Span span) {
  if (inside.rank != 2) return unsupported(reading, span, "a trace is read of a second-rank tensor only");
  std::vector<ExprId> diagonal;
  const AxisSpaces axes = reading.tree[inside.id].axes;
  if (axes[0] != axes[1]) return unsupported(reading, span, "a trace is read of what is square only");
  for (std::uint8_t k = 1; k <= axes[0].dimension; ++k) {
    const std::array slots{Slot{k, {}}, Slot{k, {}}};
    diagonal.push_back(component_of(reading.tree, inside.id, slots));
  }
  Typed typed = inside;
  typed.rank = 0;
  typed.layout = Layout::none;
  typed.id = sum_of(reading.tree, diagonal, 0, span);
  return typed;
}

}  // namespace

namespace {

/// n of "$n\times n$ matrices": what is said of these letters, or of all.
std::string said_rows(const Reading& reading, ExprId matrix) {
  const UnsizedMatrices& said = reading.names.symbols.evidence->unsized;
  std::set<std::string> rows;
  for (const SymbolId symbol : symbols_in(reading.tree, matrix)) {
    const auto own = said.rows.find(reading.tree.symbols[symbol].name);
    if (own != said.rows.end()) rows.insert(own->second);
  }
  if (rows.empty()) rows = said.sizes;
  return said.rectangular || rows.size() != 1 ? std::string() : *rows.begin();
}

std::optional<Typed> rows_of_unsized(Reading& reading, ExprId matrix, Span span) {
  const std::string rows = said_rows(reading, matrix);
  if (rows.size() != 1 || (!is_digit(rows[0]) && !is_letter(rows[0]))) return std::nullopt;
  if (is_digit(rows[0])) return Typed{.id = reading.tree.add_number(span, rows)};
  const SymbolId symbol = symbol_named(reading, {.base = rows}, rows, span);
  return Typed{.id = reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol})};
}

}  // namespace

MaybeTyped trace_or_determinant(Reading& reading, SyntaxId id, bool trace, const Around& around) {
  const Span span = reading.syntax[id].span;
  const auto whole = whole_tensor(reading, id, around);
  const auto inside = whole ? whole : elaborate(reading, id, around);
  if (!inside) return inside;
  if (inside->rank == 0 && is_unsized(reading.tree, inside->id)) {
    const UnsizedShape shape = unsized_shape(reading.tree, inside->id);
    if (shape != UnsizedShape::matrix && shape != UnsizedShape::number)
      return unsupported(reading, span, "traces and determinants are read of square matrices only");
    std::vector<Typed> operands{*inside};
    if (const auto rows = rows_of_unsized(reading, inside->id, span)) operands.push_back(*rows);
    return apply_op(reading.tree, trace ? Op::trace : Op::matrix_determinant, span, 0, operands);
  }
  const bool states = reading.names.symbols.evidence->states && inside->rank == 0 &&
                      inside->layout == Layout::none && has_operators(reading.tree, inside->id);
  if (trace && states && state_shape(reading.tree, inside->id) == StateShape::operators)
    return apply_op(reading.tree, Op::trace, span, 0, {*inside});
  if (!trace) return determinant_of(reading, id, *inside, span, around);
  if (is_triple(*inside))
    return of_each_member(reading, *inside, span,
                          [&](const Typed& member) { return trace_of(reading, member, span); });
  return trace_of(reading, *inside, span);
}
/// `\operatorname{diag}(a, b)`
MaybeTyped elaborate_diagonal(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const SyntaxId list = reading.syntax.child(id, 0);
  const std::size_t count = reading.syntax[list].count;
  if (reading.syntax[list].kind != SyntaxKind::tuple || count > most_rows)
    return unsupported(reading, span, "`diag` is read of a list of numbers only");
  const auto entries = entries_of(reading, reading.syntax.children(list), around);
  if (!entries) return std::nullopt;
  reading.found.matrices = true;
  Typed letters;
  std::vector<ExprId> diagonal;
  for (const Typed& entry : *entries) {
    merge_letters(letters, entry);
    diagonal.push_back(entry.id);
  }
  const Space space = column_space(reading.names.symbols, static_cast<int>(count));
  Typed matrix = diagonal_matrix(reading.tree, diagonal, space, span);
  merge_letters(matrix, letters);
  return matrix;
}

}  // namespace rigor
