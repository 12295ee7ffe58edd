// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/matrix_letter.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/reading/matrix_product.h"
#include "elaborate/symbol/named_symbol.h"
#include "elaborate/symbol/triple_letter.h"

namespace rigor {
namespace {

Layout layout_of_shape(MatrixShape shape) {
  if (shape.is_matrix()) return Layout::matrix;
  return shape.columns == 1 ? Layout::column : Layout::row;
}

/// The one shape that the section gives the letter.
std::optional<MatrixShape> shape_of(Reading& reading, const std::string& name, const MatrixLetter& letter,
                                    Span span) {
  if (letter.shapes.size() > 1)
    return ambiguous(reading, span,
                     fmt::format("`{}` is set equal to matrices of different sizes here", name));
  if (reading.names.symbols.evidence->plain_numbers.contains(name))
    return ambiguous(reading, span, fmt::format("`{}` is a matrix here, and a number as well", name),
                     {"give one of them another name"});
  return *letter.shapes.begin();
}

/// The whole, if its matrix is known where it stands, or is written beside it.
MaybeTyped whole_letter(Reading& reading, const WrittenSymbol& written, const MatrixLetter& letter,
                        Span span) {
  const std::string name = matrix_name(written);
  reading.found.matrices = true;
  if (triple_of_member(*reading.names.symbols.evidence, written)) reading.found.triples = true;
  const auto shape = shape_of(reading, name, letter, span);
  if (!shape) return std::nullopt;
  const int rank = shape->is_matrix() ? 2 : 1;
  const Space rows = column_space(reading.names.symbols, shape->rows == 1 ? shape->columns : shape->rows);
  const bool complex = reading.names.symbols.evidence->complex_numbers.contains(complex_name(written));
  const NameKey key{.base = name, .rank = rank, .space = rows.id, .shape = *shape, .complex = complex};
  const SymbolId symbol = symbol_named(reading, key, name, span);
  const bool known = definition_of(reading.names.scope, symbol) != nullptr ||
                     letter.set_there.contains({span.file, span.begin});
  if (!known)
    return unsupported(
        reading, span,
        fmt::format("`{}` is a matrix here, but no matrix that it equals was read above", name));
  Typed typed{.rank = rank, .layout = layout_of_shape(*shape)};
  typed.id = reading.tree.add(
      {.op = Op::symbol, .rank = static_cast<std::uint8_t>(rank), .span = span, .symbol = symbol});
  return typed;
}

/// The axes of `A_{12}`, where they are two of this matrix.
std::vector<Slot> slots_of(const WrittenSymbol& written, MatrixShape shape) {
  std::string digits;
  for (const WrittenIndex& index : written.lower) {
    if (index.form != IndexForm::digit || index.primes > 0) return {};
    digits += index.text;
  }
  if (digits.size() != 2 || !shape.is_matrix()) return {};
  const int row = digits[0] - '0';
  const int column = digits[1] - '0';
  if (row < 1 || row > shape.rows || column < 1 || column > shape.columns) return {};
  return {Slot{static_cast<std::uint8_t>(row), {}}, Slot{static_cast<std::uint8_t>(column), {}}};
}

/// Above the first row that sets the letter equal to a matrix it is any matrix, or another quantity.
bool is_above_its_matrix(const MatrixLetter& letter, Span span) {
  return std::ranges::all_of(letter.set_there, [&](const auto& place) {
    return place.first == span.file && place.second > span.end;
  });
}

/// What fails for any such letter can hold for the matrix that it equals below.
std::nullopt_t doubted(Reading& reading, const std::string& name) {
  if (!reading.found.guess)
    reading.found.guess =
        Obstacle{DiagnosticKind::ambiguous_reading,
                 fmt::format("`{}` is set equal to a matrix below, and can be that matrix here", name),
                 {}};
  return std::nullopt;
}

/// `AB = I` makes no letter of I.
bool is_only_unit(const Reading& reading, const WrittenSymbol& written) {
  const auto& matrices = reading.names.symbols.evidence->matrices;
  const auto found = matrices.find(matrix_name(written));
  return found != matrices.end() && !found->second.written && may_be_unit_matrix(reading, written);
}

/// `A_{12}` of a matrix A that is written without such letters.
std::optional<MaybeTyped> entry_of_letter(Reading& reading, const WrittenSymbol& written, Span span) {
  const Evidence& here = *reading.names.symbols.evidence;
  if (written.lower.empty()) return std::nullopt;
  WrittenSymbol bare = written;
  bare.lower.clear();
  const std::string name = matrix_name(bare);
  const auto found = here.matrices.find(name);
  const std::string labelled = name + "_";
  const bool of_its_entries = std::ranges::any_of(
      here.entries, [&](const std::string& entry) { return entry.starts_with(labelled); });
  if (!is_matrix_letter(bare, here) || is_only_unit(reading, bare) || of_its_entries) return std::nullopt;
  if (is_above_its_matrix(found->second, span)) return doubted(reading, name);
  const auto whole = whole_letter(reading, bare, found->second, span);
  if (!whole) return MaybeTyped{};
  const std::vector<Slot> slots = slots_of(written, *found->second.shapes.begin());
  if (slots.empty())
    return unsupported(reading, span,
                       fmt::format("`{}` can be an entry of the matrix `{}`, or a letter of its own",
                                   matrix_name(written), name));
  return Typed{.id = component_of(reading.tree, whole->id, slots)};
}

/// The number of rows, if all square matrices of the section have as many.
std::optional<std::uint8_t> rows_of_section(const Evidence& here) {
  std::set<std::uint8_t> rows;
  for (const auto& [name, letter] : here.matrices) {
    for (const MatrixShape& shape : letter.shapes) {
      if (shape.is_matrix() && shape.rows == shape.columns) rows.insert(shape.rows);
    }
  }
  return rows.size() == 1 ? std::optional(*rows.begin()) : std::nullopt;
}

/// `\mathbb 1`, `\mathbb I_2` beside matrices of one size.
std::optional<MaybeTyped> unit_matrix(Reading& reading, const WrittenSymbol& written, Span span) {
  const Evidence& here = *reading.names.symbols.evidence;
  if (written.letter != "\\mathbb{1}" && written.letter != "\\mathbb{I}") return std::nullopt;
  const auto known = here.matrices.find(matrix_name(written));
  const bool own = known != here.matrices.end() && known->second.written;
  const auto usual = rows_of_usual_triple(reading);
  const auto rows = usual ? usual : rows_of_section(here);
  if (own || !rows || !is_undecorated(written) || is_declared_letter(reading.names, written))
    return std::nullopt;
  const bool sized = written.lower.size() == 1 && written.lower[0].primes == 0 &&
                     written.lower[0].text == std::to_string(*rows);
  if (!written.lower.empty() && !sized) return std::nullopt;
  reading.found.matrices = true;
  const std::vector<ExprId> ones(*rows, reading.tree.add_number(span, "1"));
  return diagonal_matrix(reading.tree, ones, column_space(reading.names.symbols, *rows), span);
}

}  // namespace

std::optional<MaybeTyped> matrix_letter(Reading& reading, const WrittenSymbol& written, Span span) {
  const Evidence& here = *reading.names.symbols.evidence;
  const bool declared = is_declared_letter(reading.names, written) ||
                        is_declared(reading.names.symbols, {written.letter, 2, false});
  if ((here.matrices.empty() && !rows_of_usual_triple(reading)) || declared) return std::nullopt;
  if (auto unit = unit_matrix(reading, written, span)) return unit;
  const std::string name = matrix_name(written);
  const auto found = here.matrices.find(name);
  if (found != here.matrices.end() && !is_matrix_letter(written, here)) return std::nullopt;
  if (is_only_unit(reading, written)) return std::nullopt;
  if (found != here.matrices.end() && is_above_its_matrix(found->second, span)) return doubted(reading, name);
  if (found != here.matrices.end()) return whole_letter(reading, written, found->second, span);
  if (written.face == Face::plain && written.lower.empty() &&
      here.matrices.contains("\\mathbf{" + name + "}"))
    return unsupported(reading, span,
                       fmt::format("`{0}` can be the length of `\\mathbf{{{0}}}`, or a number", name));
  return entry_of_letter(reading, written, span);
}

bool may_be_unit_matrix(const Reading& reading, const WrittenSymbol& written) {
  const Names& names = reading.names;
  const Evidence& here = *names.symbols.evidence;
  const bool usual = written.letter == "I" || here.units.contains(written.letter);
  if (!usual || written.face != Face::plain || !written.lower.empty() || !is_undecorated(written) ||
      is_declared_letter(names, written) || here.numbers.contains(written.letter))
    return false;
  const auto number = find_symbol(names.symbols, {written.letter, 0, false});
  return !number || definition_of(names.scope, *number) == nullptr;
}

}  // namespace rigor
