// SPDX-License-Identifier: GPL-3.0-or-later
// e^{αN} where N is `\mathbf n\cdot\boldsymbol\sigma` or one of the Pauli matrices. N² is the number s² =
// n·n, so the series is e^{αN} = ½(e^{αs} + e^{−αs}) 1 + (e^{αs} − e^{−αs})/(2s) N. Other matrices have no
// exponential here.
#include <algorithm>
#include <array>
#include <vector>

#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/triple.h"

namespace rigor {
namespace {

/// The number α and the matrix N of αN; where N is n·σ, the vector n.
struct Multiple {
  std::vector<ExprId> above = {};
  std::vector<ExprId> below = {};
  bool negative = false;
  std::optional<ExprId> vector = {};
  std::optional<ExprId> matrices = {};  // one, or three in a tuple
};

/// Of a written 0, ±1 or ±i: its real and imaginary part.
std::optional<std::array<int, 2>> simple_entry(const ExprTree& tree, ExprId id) {
  if (tree[id].op == Op::imaginary_unit) return std::array{0, 1};
  if (tree[id].op == Op::number && tree.digits(id) == "0") return std::array{0, 0};
  if (tree[id].op == Op::number && tree.digits(id) == "1") return std::array{1, 0};
  if (tree[id].op != Op::negate) return std::nullopt;
  const auto inside = simple_entry(tree, tree.children(id)[0]);
  return inside ? std::optional(std::array{-(*inside)[0], -(*inside)[1]}) : std::nullopt;
}

/// What a letter is defined as; anything else itself.
ExprId unfolded(const Reading& reading, ExprId id) {
  if (reading.tree[id].op != Op::symbol || reading.tree[id].slot_count > 0) return id;
  const NamedDefinition* named = definition_of(reading.names.scope, reading.tree[id].symbol);
  return named != nullptr && named->definition.indices.empty() ? named->definition.body : id;
}

/// 0, 1 and 2 for σ_x, σ_y and σ_z.
std::optional<std::size_t> pauli_axis(const Reading& reading, ExprId letter) {
  static constexpr std::array<std::array<std::array<int, 2>, 4>, 3> known{
      {{{{0, 0}, {1, 0}, {1, 0}, {0, 0}}},
       {{{0, 0}, {0, -1}, {0, 1}, {0, 0}}},
       {{{1, 0}, {0, 0}, {0, 0}, {-1, 0}}}}};
  const ExprTree& tree = reading.tree;
  const ExprId matrix = unfolded(reading, letter);
  if (tree[matrix].op != Op::tuple || tree[matrix].rank != 2) return std::nullopt;
  std::vector<std::array<int, 2>> entries;
  for (const ExprId row : tree.children(matrix)) {
    if (tree[row].op != Op::tuple) return std::nullopt;
    for (const ExprId each : tree.children(row)) {
      const auto value = simple_entry(tree, each);
      if (!value) return std::nullopt;
      entries.push_back(*value);
    }
  }
  for (std::size_t axis = 0; axis < known.size(); ++axis) {
    if (std::ranges::equal(known[axis], entries)) return axis;
  }
  return std::nullopt;
}

bool are_pauli_matrices(const Reading& reading, ExprId triple) {
  const std::span<const ExprId> members = reading.tree.children(triple);
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (pauli_axis(reading, members[k]) != k) return false;
  }
  return members.size() == 3;
}

/// Takes the numbers before, behind and below a matrix, or three of them, off.
std::optional<Multiple> multiple_of(const Reading& reading, ExprId id) {
  const ExprTree& tree = reading.tree;
  Multiple found;
  while (true) {
    const std::span<const ExprId> children = tree.children(id);
    switch (tree[id].op) {
      case Op::negate:
        found.negative = !found.negative;
        id = children[0];
        break;
      case Op::divide:
        found.below.push_back(children[1]);
        id = children[0];
        break;
      case Op::multiply: {
        const auto matrix = std::ranges::find_if(children, [&](ExprId each) { return tree[each].rank > 0; });
        if (matrix == children.end() || tree[*matrix].rank != tree[id].rank) return std::nullopt;
        for (const ExprId each : children) {
          if (each != *matrix) found.above.push_back(each);
        }
        id = *matrix;
        break;
      }
      case Op::dot:
        if (found.vector || tree[children[0]].rank != 1 || tree[children[1]].rank != 3) return std::nullopt;
        found.vector = children[0];
        id = children[1];
        break;
      case Op::symbol:
        if (unfolded(reading, id) == id) return std::nullopt;
        id = unfolded(reading, id);
        break;
      case Op::tuple:
        if (found.vector ? !are_pauli_matrices(reading, id) : !pauli_axis(reading, id)) return std::nullopt;
        found.matrices = id;
        return found;
      default:
        return std::nullopt;
    }
  }
}

}  // namespace

MaybeTyped matrix_exponential(Reading& reading, const Typed& argument, Span span) {
  const auto multiple = multiple_of(reading, argument.id);
  if (!multiple)
    return unsupported(
        reading, span,
        "an exponential of a matrix is read of a multiple of `\\mathbf{n}\\cdot\\sigma` with the "
        "Pauli matrices only");
  ExprTree& tree = reading.tree;
  const auto make = [&](Op op, const std::vector<ExprId>& children, int rank = 0) {
    return tree.add({.op = op, .rank = static_cast<std::uint8_t>(rank), .span = span}, children);
  };
  const auto product = [&](const std::vector<ExprId>& factors) {
    return factors.empty() ? tree.add_number(span, "1") : make(Op::multiply, factors);
  };
  ExprId number = product(multiple->above);
  if (!multiple->below.empty()) number = make(Op::divide, {number, product(multiple->below)});
  if (multiple->negative) number = make(Op::negate, {number});
  ExprId matrix = *multiple->matrices;
  std::optional<ExprId> length;
  if (multiple->vector) {
    matrix = make(Op::dot, {*multiple->vector, matrix}, 2);
    if (tree[*multiple->vector].op != Op::basis) length = make(Op::length, {*multiple->vector});
  }
  const auto exponential = [&](bool negative) {
    ExprId above = length ? make(Op::multiply, {number, *length}) : number;
    if (negative) above = make(Op::negate, {above});
    return tree.add({.op = Op::function, .span = span, .function = Function::exp}, std::span(&above, 1));
  };
  const ExprId there = exponential(false);
  const ExprId back = exponential(true);
  const ExprId two = tree.add_number(span, "2");
  const ExprId even = make(Op::divide, {make(Op::add, {there, back}), two});
  const ExprId odd = make(Op::divide, {make(Op::add, {there, make(Op::negate, {back})}),
                                       length ? make(Op::multiply, {two, *length}) : two});
  Typed result = diagonal_matrix(tree, {even, even}, tree[matrix].axes[0], span);
  const Typed second{.id = make(Op::multiply, {odd, matrix}, 2), .rank = 2, .layout = Layout::matrix};
  result = apply_op(tree, Op::add, span, 2, {result, second});
  merge_letters(result, argument);
  return result;
}

}  // namespace rigor
