// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/matrix_product.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>

#include "elaborate/evidence/evidence.h"
#include "elaborate/reading/triple.h"

namespace rigor {
namespace {

constexpr int largest_power = 16;
constexpr std::size_t largest_inverse = 4;            // rows
constexpr std::uint32_t heaviest_determinant = 4000;  // six rows of letters
constexpr std::uint32_t heaviest_factor = 20'000;     // each power multiplies what is below it

ExprId entry(ExprTree& tree, const Typed& matrix, std::size_t row, std::size_t column) {
  const Slot slots[] = {{static_cast<std::uint8_t>(row + 1), {}},
                        {static_cast<std::uint8_t>(column + 1), {}}};
  return component_of(tree, matrix.id, slots);
}

/// Row by row; `letters` has the particles of what they are made of.
Typed matrix_of(ExprTree& tree, const std::vector<ExprId>& entries, Space rows, Space columns, Span span,
                const Typed& letters = {}) {
  std::vector<Typed> lines;
  for (std::size_t k = 0; k < entries.size(); k += columns.dimension) {
    std::vector<Typed> line;
    for (std::size_t j = 0; j < columns.dimension; ++j) line.push_back({.id = entries[k + j]});
    lines.push_back(tuple_of(tree, columns, span, line));
  }
  Typed matrix = tuple_of(tree, rows, span, lines);
  merge_letters(matrix, letters);
  matrix.layout = Layout::matrix;
  return matrix;
}

/// A letter beside a matrix that nothing says to be a number; what is defined is what it is made of.
const Symbol* open_letter(const Reading& reading, ExprId number) {
  const Names& names = reading.names;
  for (const SymbolId symbol : symbols_reached(reading.tree, names.scope, {number})) {
    const Symbol& letter = reading.tree.symbols[symbol];
    const SymbolId base = base_of(reading.tree.symbols, symbol);
    const NameKey* key = key_of(names.symbols, base);
    if (key == nullptr || key->shape.any() || letter.is_fixed() || reading.tree.symbols[base].declared)
      continue;
    const std::string bare = without_labels(key->base);
    if (key->rank > 0 && names.symbols.evidence->vectors.contains(bare)) continue;
    if (definition_of(names.scope, base) != nullptr || definition_of(names.scope, symbol) != nullptr)
      continue;
    if (may_be_a_matrix(bare, *names.symbols.evidence)) return &letter;
  }
  return nullptr;
}

std::nullopt_t no_product(Reading& reading, Span span, const char* left, const char* right) {
  return unsupported(reading, span, fmt::format("{} beside {} has no product of matrices", left, right));
}

MaybeTyped product_of_two(Reading& reading, const Typed& left, const Typed& right, Span span) {
  ExprTree& tree = reading.tree;
  const Span place = tree[right.id].span;
  if (is_triple(left) != is_triple(right) && left.rank + right.rank == 5) {
    const Typed& matrix = is_triple(left) ? right : left;
    if (tree[matrix.id].axes[0] == common_space || tree[matrix.id].axes[0] != tree[matrix.id].axes[1])
      return ambiguous(reading, place,
                       "this matrix can turn the vector of matrices, or multiply each of them");
    return of_each_member(reading, is_triple(left) ? left : right, span, [&](const Typed& member) {
      return product_of_two(reading, is_triple(left) ? member : left, is_triple(left) ? right : member, span);
    });
  }
  if (left.rank + right.rank > 4 || left.rank > 2 || right.rank > 2)
    return unsupported(reading, place, "a product of a matrix and a tensor of higher rank is not read");
  const bool row = left.layout == Layout::row;
  const bool into_row = right.layout == Layout::row;
  if (left.rank == 1 && !row) {
    if (!into_row) return no_product(reading, place, "a column", right.rank == 1 ? "a column" : "a matrix");
    Typed product = apply_op(tree, Op::multiply, span, 2, {left, right});
    product.layout = Layout::matrix;
    return product;
  }
  if (into_row) return no_product(reading, place, row ? "a row" : "a matrix", "a row");
  const Space inner = tree[left.id].axes[left.rank - 1];
  if (inner != tree[right.id].axes[0])
    return unsupported(reading, place,
                       fmt::format("the factor before has {} columns, but this one has {} rows",
                                   inner.dimension, tree[right.id].axes[0].dimension));
  const int rank = left.rank + right.rank - 2;
  Typed product = apply_op(tree, Op::dot, span, rank, {left, right});
  product.layout = rank == 0 ? Layout::none : rank == 2 ? Layout::matrix : row ? Layout::row : Layout::column;
  return product;
}

/// Of the rows from `row` on and the columns that are left, each of these minors once.
class Minors {
 public:
  Minors(ExprTree& tree, const std::vector<ExprId>& entries, std::size_t size, Span span)
      : tree_(tree), entries_(entries), size_(size), span_(span) {}

  ExprId of(std::size_t row, unsigned columns) {
    const auto known = minors_.find(columns);
    if (known != minors_.end()) return known->second;
    if (size_ - row <= 3) return minors_[columns] = small(row, columns);
    std::vector<Typed> along;
    std::vector<Typed> cofactors;
    bool odd = false;
    for (std::size_t column = 0; column < size_; ++column) {
      if ((columns & (1U << column)) == 0) continue;
      const ExprId factor = entries_[row * size_ + column];
      if (!tree_.is_zero_literal(factor)) {
        ExprId minor = of(row + 1, columns & ~(1U << column));
        if (odd) minor = tree_.add({.op = Op::negate, .span = span_}, std::span(&minor, 1));
        along.push_back({.id = factor});
        cofactors.push_back({.id = minor});
      }
      odd = !odd;
    }
    const ExprId minor = along.empty() ? tree_.add_number(span_, "0") : contracted(along, cofactors);
    return minors_[columns] = minor;
  }

 private:
  /// Of three rows and less: as it would be written.
  ExprId small(std::size_t row, unsigned columns) {
    std::vector<ExprId> rest;
    for (std::size_t k = row * size_; k < entries_.size(); ++k) {
      if ((columns & (1U << (k % size_))) != 0) rest.push_back(entries_[k]);
    }
    if (rest.size() == 1) return rest[0];
    if (rest.size() == 9) return tree_.add({.op = Op::determinant, .span = span_}, rest);
    const ExprId falling[] = {rest[0], rest[3]};
    const ExprId rising[] = {rest[1], rest[2]};
    const ExprId subtracted = tree_.add({.op = Op::multiply, .span = span_}, rising);
    return sum_of(tree_,
                  {tree_.add({.op = Op::multiply, .span = span_}, falling),
                   tree_.add({.op = Op::negate, .span = span_}, std::span(&subtracted, 1))},
                  0, span_);
  }

  /// A contraction and no sum of products: nobody wrote its factors in this order, which may show matrices.
  ExprId contracted(const std::vector<Typed>& along, const std::vector<Typed>& cofactors) {
    const ExprId factors[] = {along[0].id, cofactors[0].id};
    if (along.size() == 1) return tree_.add({.op = Op::multiply, .span = span_}, factors);
    const Space space{static_cast<std::uint8_t>(along.size()), space_of_columns};
    const ExprId tuples[] = {tuple_of(tree_, space, span_, along).id,
                             tuple_of(tree_, space, span_, cofactors).id};
    return tree_.add({.op = Op::dot, .span = span_}, tuples);
  }

  ExprTree& tree_;
  const std::vector<ExprId>& entries_;
  std::size_t size_;
  Span span_;
  std::map<unsigned, ExprId> minors_;
};

/// `1`, `-\frac{3}{4}\hbar^2`, `2i`: beside a square matrix it can only be that multiple of the unit matrix.
bool is_plain_number(const ExprTree& tree, const Typed& typed) {
  if (typed.rank != 0 || !typed.free.empty() || tree.is_zero_literal(typed.id)) return false;
  return std::ranges::all_of(symbols_in(tree, typed.id), [&](SymbolId symbol) {
    const std::string& name = tree.symbols[symbol].name;
    return name == "\\hbar" || name == "\\pi";
  });
}

/// `\mathbf a\cdot\mathbf b`, `\cos\theta`, `2\delta_{ij}`: made of what cannot be a matrix itself.
bool is_number_of_letters(const Reading& reading, const Typed& typed) {
  const ExprTree& tree = reading.tree;
  return typed.rank == 0 && !tree.is_zero_literal(typed.id) && tree[typed.id].op != Op::symbol &&
         !has_operators(tree, typed.id) && open_letter(reading, typed.id) == nullptr;
}

std::size_t root_of(std::size_t square) {
  std::size_t size = 0;
  while (size * size < square) ++size;
  return size;
}

ExprId determinant(ExprTree& tree, const std::vector<ExprId>& entries, Span span) {
  const std::size_t size = root_of(entries.size());
  return Minors(tree, entries, size, span).of(0, (1U << size) - 1);
}

/// Without this row and this column.
std::vector<ExprId> without(const std::vector<ExprId>& entries, std::size_t row, std::size_t column) {
  const std::size_t size = root_of(entries.size());
  std::vector<ExprId> rest;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k / size != row && k % size != column) rest.push_back(entries[k]);
  }
  return rest;
}

/// (A⁻¹)_ij = (−1)^(i+j) M_ji / det A with the minors M.
MaybeTyped inverse(Reading& reading, const Typed& matrix, Span span) {
  ExprTree& tree = reading.tree;
  const std::vector<ExprId> entries = square_entries(tree, matrix);
  const std::size_t size = root_of(entries.size());
  if (size > largest_inverse)
    return unsupported(reading, span, "inverses are read of matrices of up to four rows");
  std::vector<ExprId> adjugate;
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      const std::vector<ExprId> rest = without(entries, column, row);
      ExprId minor = determinant(tree, rest, span);
      if ((row + column) % 2 == 1) minor = tree.add({.op = Op::negate, .span = span}, std::span(&minor, 1));
      adjugate.push_back(minor);
    }
  }
  const Space space = tree[matrix.id].axes[0];
  const Typed above = matrix_of(tree, adjugate, space, space, span, matrix);
  const Typed below{.id = determinant(tree, entries, span)};
  return apply_op(tree, Op::divide, span, 2, {above, below});
}

}  // namespace

MaybeTyped product_of_matrices(Reading& reading, std::vector<Typed> numbers,
                               const std::vector<Typed>& factors, Span span) {
  reading.found.matrices = true;
  const bool says_unit = !reading.names.symbols.evidence->units.empty();  // "the unit matrix $I$"
  for (Typed& number : numbers) {
    if (number.with_unit && says_unit) number.id = *number.with_unit;
    if (const Symbol* letter = open_letter(reading, number.id))
      return ambiguous(
          reading, reading.tree[number.id].span,
          fmt::format("`{}` beside a matrix can be a number, a matrix or a column", letter->name),
          {fmt::format("`rigor: scalar {}` makes it a number", letter->name)});
  }
  MaybeTyped product = factors[0];
  for (std::size_t k = 1; product && k < factors.size(); ++k) {
    if (product->rank == 0) {
      numbers.push_back(*product);
      product = factors[k];
    } else if (factors[k].rank == 0) {
      numbers.push_back(factors[k]);
    } else {
      product = product_of_two(reading, *product, factors[k],
                               cover(reading.tree[product->id].span, reading.tree[factors[k].id].span));
    }
  }
  if (!product || numbers.empty()) return product;
  numbers.push_back(*product);
  return apply_op(reading.tree, Op::multiply, span, product->rank, numbers);
}

Typed transposed(ExprTree& tree, const Typed& typed, Span span) {
  Typed result = typed;
  if (typed.rank == 1) {
    result.layout = typed.layout == Layout::row ? Layout::column : Layout::row;
    return result;
  }
  const AxisSpaces axes = tree[typed.id].axes;
  std::vector<ExprId> entries;
  for (std::size_t column = 0; column < axes[1].dimension; ++column) {
    for (std::size_t row = 0; row < axes[0].dimension; ++row)
      entries.push_back(entry(tree, typed, row, column));
  }
  return matrix_of(tree, entries, axes[1], axes[0], span, typed);
}

MaybeTyped determinant_of_entries(Reading& reading, const std::vector<ExprId>& entries, Span span) {
  const ExprId value = determinant(reading.tree, entries, span);
  if (reading.tree[value].weight > heaviest_determinant)
    return unsupported(reading, span, "this determinant has too many terms to be read");
  return Typed{.id = value};
}

MaybeTyped matrix_power(Reading& reading, const Typed& base, int exponent, Span span) {
  if (base.layout == Layout::column && exponent == 2 && !has_complex_numbers(reading.tree, base.id))
    return apply_op(reading.tree, Op::dot, span, 0, {base, base});
  if (base.rank == 1)
    return ambiguous(reading, span, "a power of a column can be one of its length, or is not defined",
                     {"write the product with the transpose, or `|…|`"});
  ExprTree& tree = reading.tree;
  if (square_entries(tree, base).empty())
    return unsupported(reading, span, "only square matrices have powers");
  if (std::abs(exponent) > largest_power)
    return unsupported(reading, span, "powers of matrices are read up to 16");
  const Space space = tree[base.id].axes[0];
  if (exponent == 0)
    return diagonal_matrix(tree, std::vector<ExprId>(space.dimension, tree.add_number(span, "1")), space,
                           span);
  const auto factor = exponent > 0 ? std::optional(base) : inverse(reading, base, span);
  if (!factor) return std::nullopt;
  if (tree[factor->id].weight > heaviest_factor)
    return unsupported(reading, span, "powers inside powers of matrices are read for a few only");
  Typed power = *factor;
  for (int k = 1; k < std::abs(exponent); ++k) power = apply_op(tree, Op::dot, span, 2, {power, *factor});
  return power;
}

std::vector<ExprId> square_entries(ExprTree& tree, const Typed& typed) {
  if (typed.rank != 2) return {};
  const AxisSpaces axes = tree[typed.id].axes;
  if (axes[0] != axes[1]) return {};
  std::vector<ExprId> entries;
  for (std::size_t k = 0; k < component_count(2, axes); ++k)
    entries.push_back(entry(tree, typed, k / axes[0].dimension, k % axes[0].dimension));
  return entries;
}

Typed diagonal_matrix(ExprTree& tree, const std::vector<ExprId>& diagonal, Space space, Span span) {
  const std::size_t size = diagonal.size();
  std::vector<ExprId> entries(size * size, tree.add_number(span, "0"));
  for (std::size_t k = 0; k < size; ++k) entries[k * (size + 1)] = diagonal[k];
  return matrix_of(tree, entries, space, space, span);
}

Typed beside_matrix(Reading& reading, const Typed& typed, const Typed& matrix) {
  ExprTree& tree = reading.tree;
  const bool number =
      is_plain_number(tree, typed) || (reading.found.triples && is_number_of_letters(reading, typed));
  if (matrix.layout != Layout::matrix || typed.rank != 0 || (!typed.with_unit && !number)) return typed;
  const AxisSpaces axes = tree[matrix.id].axes;
  if (axes[0] != axes[1]) return typed;
  Typed multiple = diagonal_matrix(
      tree, std::vector<ExprId>(axes[0].dimension, typed.with_unit ? *typed.with_unit : typed.id), axes[0],
      tree[typed.id].span);
  merge_letters(multiple, typed);
  if (reading.found.triples && !typed.with_unit)
    note(reading, "a number beside a matrix is that multiple of the unit matrix");
  return multiple;
}

}  // namespace rigor
