// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elaborate/notation/notations.h"
#include "elaborate/symbol/named_symbol.h"

namespace rigor {
namespace {

/// `\det A` where A_{ij} is a tensor.
MaybeTyped whole_tensor(Reading& reading, SyntaxId id, const Around& around) {
  if (reading.syntax[id].kind != SyntaxKind::symbol) return std::nullopt;
  const WrittenSymbol& written = reading.syntax.symbol(id);
  if (!is_undecorated(written) || !written.lower.empty()) return std::nullopt;
  const bool tensor = is_known(reading.names, written.letter, 2, false) &&
                      !is_declared(reading.names.symbols, {written.letter, 0, false});
  if (!tensor) return std::nullopt;
  const WrittenName name{.base = written.letter, .axes = {}, .particles = {}};
  return named_symbol(reading, {written, name, reading.syntax[id].span, around}, written.letter, 2);
}

}  // namespace

MaybeTyped elaborate_tuple(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const Space space = use_space(reading);
  if (reading.syntax[id].payload >= in_square_brackets && space.dimension != 2)
    return elaborate_pair(reading, id, around);
  if (reading.syntax[id].count != space.dimension)
    return unsupported(reading, span,
                       space == common_space
                           ? "only tuples of three components are read"
                           : fmt::format("a vector of this space has {} components", space.dimension));
  std::vector<Typed> entries;
  for (const SyntaxChild& child : reading.syntax.children(id)) {
    auto entry = elaborate(reading, child.id, around);
    if (!entry) return std::nullopt;
    entries.push_back(std::move(*entry));
    if (entries.back().rank != 0)
      return unsupported(reading, reading.syntax[child.id].span,
                         "a bracket of vectors is not read; write a triple product out");
    if (!entries.back().free.empty())
      return unsupported(reading, reading.syntax[child.id].span,
                         "a free index inside a tuple is not decided");
  }
  return tuple_of(reading.tree, space, span, entries);
}

MaybeTyped elaborate_matrix(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  const Space space = use_space(reading);
  const std::size_t size = space.dimension;
  if (reading.syntax[id].count != size * size || reading.syntax[id].payload != size)
    return unsupported(reading, span,
                       space == common_space
                           ? "only matrices of three rows and three columns are read"
                           : fmt::format("a matrix of this space has {0} rows and {0} columns", size));
  std::vector<Typed> rows;
  for (std::size_t row = 0; row < size; ++row) {
    std::vector<Typed> entries;
    for (std::size_t column = 0; column < size; ++column) {
      auto entry = elaborate(reading, reading.syntax.child(id, size * row + column), around);
      if (!entry) return std::nullopt;
      if (entry->rank != 0 || !entry->free.empty())
        return unsupported(reading, span, "an entry of this matrix is not a plain scalar");
      entries.push_back(std::move(*entry));
    }
    rows.push_back(tuple_of(reading.tree, space, span, entries));
  }
  return tuple_of(reading.tree, space, span, rows);
}

MaybeTyped elaborate_determinant(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  if (space_of(reading.names.symbols) != common_space)
    return unsupported(reading, span, "a determinant is read in three dimensions only");
  if (reading.syntax[id].count != 9 || reading.syntax[id].payload != 3)
    return unsupported(reading, span, "only determinants of three rows are read");
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
  // Each entry occurs in several products, so a letter's place in them is not that of the summation
  // convention.
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
  return apply_op(reading.tree, Op::determinant, span, entries[0].rank, entries);
}

MaybeTyped determinant_of(Reading& reading, SyntaxId id, const Typed& inside, Span span,
                          const Around& around) {
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

MaybeTyped trace_or_determinant(Reading& reading, SyntaxId id, bool trace, const Around& around) {
  const Span span = reading.syntax[id].span;
  const auto whole = whole_tensor(reading, id, around);
  const auto inside = whole ? whole : elaborate(reading, id, around);
  if (!inside) return inside;
  if (!trace) return determinant_of(reading, id, *inside, span, around);
  if (inside->rank != 2) return unsupported(reading, span, "a trace is read of a second-rank tensor only");
  std::vector<ExprId> diagonal;
  const AxisSpaces axes = reading.tree[inside->id].axes;
  if (axes[0] != axes[1]) return unsupported(reading, span, "a trace is read of a square tensor only");
  for (std::uint8_t k = 1; k <= axes[0].dimension; ++k) {
    const std::array slots{Slot{k, {}}, Slot{k, {}}};
    diagonal.push_back(component_of(reading.tree, inside->id, slots));
  }
  Typed typed = *inside;
  typed.rank = 0;
  typed.id = sum_of(reading.tree, diagonal, 0, span);
  return typed;
}

}  // namespace rigor
