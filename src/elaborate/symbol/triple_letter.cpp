// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/triple_letter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/triple.h"
#include "elaborate/symbol/axes.h"
#include "elaborate/symbol/named_symbol.h"

namespace rigor {
namespace {

/// The triple of a letter in this row; the usual one not beside operators, of which it may be one itself.
std::optional<MatrixTriple> triple_here(const Reading& reading, const std::string& letter) {
  const Symbols& symbols = reading.names.symbols;
  const bool declared = is_declared(symbols, {letter, 0, false}) || is_declared(symbols, {letter, 1, false});
  if (declared || space_of(symbols) != common_space) return std::nullopt;
  auto triple = triple_of(*symbols.evidence, letter);
  if (triple && triple->usual && reading.letters.has_operators) return std::nullopt;
  return triple;
}

/// σ_x, σ_y and σ_z.
std::vector<Typed> pauli_matrices(Reading& reading, Span span) {
  ExprTree& tree = reading.tree;
  const ExprId zero = tree.add_number(span, "0");
  const ExprId one = tree.add_number(span, "1");
  const ExprId i = tree.add({.op = Op::imaginary_unit, .span = span});
  const ExprId minus_one = tree.add({.op = Op::negate, .span = span}, std::span(&one, 1));
  const ExprId minus_i = tree.add({.op = Op::negate, .span = span}, std::span(&i, 1));
  const Space space = column_space(reading.names.symbols, 2);
  const std::array<std::array<ExprId, 4>, 3> entries{
      {{zero, one, one, zero}, {zero, minus_i, i, zero}, {one, zero, zero, minus_one}}};
  std::vector<Typed> matrices;
  for (const auto& [a, b, c, d] : entries) {
    const std::vector<Typed> rows{tuple_of(tree, space, span, {{.id = a}, {.id = b}}),
                                  tuple_of(tree, space, span, {{.id = c}, {.id = d}})};
    matrices.push_back(tuple_of(tree, space, span, rows));
    matrices.back().layout = Layout::matrix;
  }
  return matrices;
}

/// The letters of the three matrices, each with the definition that was read above; nothing where one was
/// not.
std::optional<std::vector<Typed>> defined_members(Reading& reading, const MatrixTriple& triple, Span span) {
  const Symbols& symbols = reading.names.symbols;
  const Space space = column_space(symbols, triple.shape.rows);
  std::vector<Typed> members;
  for (const std::string& name : triple.members) {
    const bool complex = symbols.evidence->complex_numbers.contains(name);
    const NameKey key{.base = name, .rank = 2, .space = space.id, .shape = triple.shape, .complex = complex};
    const SymbolId symbol = symbol_named(reading, key, name, span);
    if (definition_of(reading.names.scope, symbol) == nullptr) return std::nullopt;
    Typed member{.rank = 2, .layout = Layout::matrix};
    member.id = reading.tree.add({.op = Op::symbol, .rank = 2, .span = span, .symbol = symbol});
    members.push_back(member);
  }
  return members;
}

/// A vector of matrices that the notes define by another one: a symbol of rank 3.
std::optional<Typed> defined_vector(Reading& reading, const std::string& letter, const MatrixTriple& triple,
                                    Span span) {
  const Symbols& symbols = reading.names.symbols;
  const NameKey key{.base = letter,
                    .rank = 3,
                    .space = column_space(symbols, triple.shape.rows).id,
                    .shape = triple.shape,
                    .complex = true};
  const SymbolId symbol = symbol_named(reading, key, bold(letter), span);
  const MatrixLetter& known = symbols.evidence->triples.at(letter);
  if (definition_of(reading.names.scope, symbol) == nullptr &&
      !known.set_there.contains({span.file, span.begin}))
    return std::nullopt;
  Typed whole{.rank = 3, .layout = Layout::triple};
  whole.id = reading.tree.add({.op = Op::symbol, .rank = 3, .span = span, .symbol = symbol});
  return whole;
}

/// All three; nothing where no matrices were read above.
std::optional<Typed> whole_of(Reading& reading, const std::string& letter, const MatrixTriple& triple,
                              Span span) {
  if (triple.usual) {
    note(reading, fmt::format("`{}` stands for the Pauli matrices, which these notes name", letter));
  } else if (triple.members[0].empty()) {
    return defined_vector(reading, letter, triple, span);
  }
  const auto members = triple.usual ? pauli_matrices(reading, span) : defined_members(reading, triple, span);
  if (!members) return std::nullopt;
  Typed whole = tuple_of(reading.tree, common_space, span, *members);
  whole.layout = Layout::triple;
  return whole;
}

/// `\sigma_n`, where n can be an index or a direction, and `\sigma_{i'}`.
bool may_be_other_member(const WrittenSymbol& written) {
  return written.face == Face::plain && written.lower.size() == 1 &&
         written.lower[0].form == IndexForm::letter && axis_of_letter(written.lower[0].text) == 0;
}

/// `S_i` where `S_i = \frac\hbar2\sigma_i` stands, and S is not defined above: both sides are read as the
/// vectors of all three.
bool defines_all(const Reading& reading, const std::string& letter, const WrittenSymbol& written, Span span) {
  const auto& triples = reading.names.symbols.evidence->triples;
  const auto found = triples.find(letter);
  return found != triples.end() && found->second.set_there.contains({span.file, span.begin}) &&
         written.face == Face::plain && axis_of_letter(written.lower[0].text) == 0;
}

/// `\sigma_i`; also `\sigma_a` where \mathbf a is a vector, if `\delta_{ab}` shows that a is an index here.
bool is_member(const Reading& reading, const WrittenSymbol& written) {
  if (triple_of_member(*reading.names.symbols.evidence, written)) return true;
  return may_be_other_member(written) && written.lower[0].primes == 0 &&
         reading.letters.indices.contains(written.lower[0].text);
}

/// `\boldsymbol\sigma_1` beside the matrices of \sigma: of one of several spins, so that they act on a
/// product space.
bool is_one_of_many(const Reading& reading, const WrittenSymbol& written) {
  const Evidence& here = *reading.names.symbols.evidence;
  const std::string letter = letter_with_marks(written);
  const bool many = written.face == Face::vector || written.lower.size() > 1;
  if (!many || !here.many_triples.contains(letter)) return false;
  return std::ranges::any_of(here.matrices, [&](const auto& each) {
    const auto& shapes = each.second.shapes;
    return each.first.starts_with(letter + "_{") &&
           std::ranges::all_of(shapes, [](MatrixShape shape) { return shape.is_matrix(); });
  });
}

}  // namespace

std::optional<MaybeTyped> triple_letter(Reading& reading, const WrittenSymbol& written, Span span,
                                        const Around& around) {
  const std::string letter = letter_with_marks(written);
  if (is_one_of_many(reading, written))
    return MaybeTyped(ambiguous(
        reading, span,
        fmt::format("`{0}` has matrices here, and labels as well: each label can be a space of its own",
                    letter)));
  const auto triple = triple_here(reading, letter);
  if (!triple) return std::nullopt;
  const Evidence& here = *reading.names.symbols.evidence;
  const bool bare = written.lower.empty() && written.face == Face::plain;
  if (bare && !here.vectors.contains(letter)) return std::nullopt;
  if (bare)
    return MaybeTyped(unsupported(
        reading, span,
        fmt::format("`{}` can be a number, or belong to the vector of matrices `{}`", letter, bold(letter))));
  const bool member = is_member(reading, written);
  if (!member && !whole_triple(here, written)) {
    if (!may_be_other_member(written)) return std::nullopt;
    return MaybeTyped(unsupported(
        reading, span,
        fmt::format("the subscript of `{}_{}` can be an index or a label", letter, written.lower[0].text)));
  }
  if (written.dots > 0)
    return MaybeTyped(unsupported(reading, span, "a rate of a vector of matrices is not decided"));
  const bool counted = member && is_one_of(written.lower[0].text, reading.counting);
  if (counted)
    return MaybeTyped(unsupported(
        reading, span,
        fmt::format("`{}_{}` can be one of three matrices, or one of many", letter, written.lower[0].text)));
  const auto whole = whole_of(reading, letter, *triple, span);
  if (!whole) return std::nullopt;
  reading.found.triples = true;
  reading.found.matrices = true;
  use_space(reading);
  if (!member) return *whole;
  if (defines_all(reading, letter, written, span)) {
    note(reading, fmt::format("the row is about all three `{}`", letter + "_" + written.lower[0].text));
    reading.found.index_of_all = written.lower[0].text;
  }
  if (reading.found.index_of_all == written.lower[0].text) return *whole;
  const auto axes = subscript(reading, written.lower, span, around);
  if (!axes) return MaybeTyped{};
  return member_of(reading.tree, *whole, axes->slots[0], axes->free, span);
}

std::optional<MaybeTyped> triple_without_index(Reading& reading, const WrittenSymbol& written, Span span) {
  const std::string letter = letter_with_marks(written);
  const auto triple = triple_here(reading, letter);
  const bool capital = letter.size() == 1 && is_capital_letter(letter[0]);
  const bool plain = written.face == Face::plain && written.lower.empty() && written.dots == 0;
  if (!triple || !plain || !capital || is_matrix_letter(written, *reading.names.symbols.evidence))
    return std::nullopt;
  const auto whole = whole_of(reading, letter, *triple, span);
  if (!whole) return std::nullopt;
  reading.found.triples = true;
  reading.found.matrices = true;
  note(reading, fmt::format("`{0}^2` is the sum of the squares of the components of `{0}`", letter));
  return *whole;
}

bool holds_triple(const Reading& reading, SyntaxId id) {
  const Evidence& here = *reading.names.symbols.evidence;
  return std::ranges::any_of(nodes_below(reading.syntax, {id}), [&](SyntaxId each) {
    if (reading.syntax[each].kind != SyntaxKind::symbol) return false;
    const WrittenSymbol& symbol = reading.syntax.symbol(each);
    const bool named = is_member(reading, symbol) || whole_triple(here, symbol);
    return named && triple_here(reading, letter_with_marks(symbol));
  });
}

std::optional<std::uint8_t> rows_of_usual_triple(const Reading& reading) {
  const bool usual = reading.letters.has_usual_triple && !reading.letters.has_operators;
  return usual ? std::optional(std::uint8_t{2}) : std::nullopt;
}

}  // namespace rigor
