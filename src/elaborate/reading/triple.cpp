// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/triple.h"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string_view>

#include "base/among.h"
#include "elaborate/reading/matrix_product.h"

namespace rigor {
namespace {

constexpr std::uint8_t axes_of_space = 3;

Typed member_along(ExprTree& tree, const Typed& triple, std::uint8_t axis, Span span) {
  return member_of(tree, triple, Slot{axis, {}}, {}, span);
}

/// A vector that can be one of operators, the components of which do not commute: `\mathbf L`. Numbers are
/// what the notes define or declare.
std::optional<std::string> vector_of_operators(const Reading& reading, const Typed& vector) {
  static constexpr auto operators = std::to_array<std::string_view>(
      {"L", "J", "\\pi", "\\Pi", "S", "s", "l", "j", "I", "\\tau", "\\Sigma", "\\sigma", "T"});
  const Names& names = reading.names;
  for (const SymbolId symbol : symbols_in(reading.tree, vector.id)) {
    const NameKey* key = key_of(names.symbols, base_of(reading.tree.symbols, symbol));
    if (key == nullptr || reading.tree.symbols[symbol].declared ||
        definition_of(names.scope, symbol) != nullptr)
      continue;
    const std::string letter = without_labels(key->base);
    // p does not commute with what depends on the place; alone its components are as good as numbers.
    const bool beside_others = (letter == "p" || letter == "P") && reading.letters.bold_vectors.size() > 2;
    if (is_one_of(letter, operators) || (letter == "p" && beside_others))
      return reading.tree.symbols[symbol].name;
  }
  return std::nullopt;
}

/// Can the vector be multiplied with the triple, component by component?
bool fits_triple(Reading& reading, const Typed& vector, const Typed& triple, Span span) {
  ExprTree& tree = reading.tree;
  const Span place = tree[vector.id].span;
  if (vector.rank != 1 || tree[vector.id].axes[0] != common_space) {
    unsupported(reading, span, "a vector of matrices is multiplied with vectors of three components only");
    return false;
  }
  const bool of_matrices = vector.layout != Layout::none && tree[triple.id].axes[1] == common_space;
  if (of_matrices) {
    ambiguous(reading, place, "this can be a vector of space, or a column that the matrices act on");
    return false;
  }
  if (has_operators(tree, vector.id) || has_operators(tree, triple.id)) {
    unsupported(reading, span, "a vector of matrices beside a vector of operators is not read");
    return false;
  }
  if (const auto name = vector_of_operators(reading, vector)) {
    ambiguous(reading, place,
              fmt::format("`{}` can be a vector of operators, which need not commute, or of numbers", *name),
              {fmt::format("`rigor: vector {}` says that its components are numbers", *name)});
    return false;
  }
  return true;
}

Typed triple_made_of(ExprTree& tree, const std::vector<Typed>& members, Span span) {
  Typed whole = tuple_of(tree, common_space, span, members);
  whole.layout = whole.rank == 3 ? Layout::triple : Layout::none;
  return whole;
}

/// A_j B_k, where one of both may be a vector of numbers.
MaybeTyped product_along(Reading& reading, const Typed& left, std::uint8_t j, const Typed& right,
                         std::uint8_t k, Span span) {
  ExprTree& tree = reading.tree;
  if (is_triple(left) && is_triple(right))
    return product_of_matrices(reading, {},
                               {member_along(tree, left, j, span), member_along(tree, right, k, span)}, span);
  const Typed& vector = is_triple(left) ? right : left;
  const Typed& triple = is_triple(left) ? left : right;
  const std::array slots{Slot{is_triple(left) ? k : j, {}}};
  Typed number{.id = component_of(tree, vector.id, slots)};
  merge_letters(number, vector);
  const Typed matrix = member_along(tree, triple, is_triple(left) ? j : k, span);
  return apply_op(tree, Op::multiply, span, 2, {number, matrix});
}

/// \mathbf A\cdot\mathbf B of two triples.
MaybeTyped sum_of_products(Reading& reading, const Typed& left, const Typed& right, Span span) {
  if (reading.tree[left.id].axes[1] != reading.tree[right.id].axes[1])
    return unsupported(reading, span, "the matrices of both vectors have different sizes");
  std::vector<Typed> terms;
  for (std::uint8_t k = 1; k <= axes_of_space; ++k) {
    const auto term = product_along(reading, left, k, right, k, span);
    if (!term) return std::nullopt;
    terms.push_back(*term);
  }
  return apply_op(reading.tree, Op::add, span, 2, terms);
}

}  // namespace

Typed member_of(ExprTree& tree, const Typed& triple, Slot slot, std::vector<FreeIndex> free, Span span) {
  Typed member{.rank = 2, .free = triple.free, .particles = triple.particles, .bound = triple.bound};
  member.layout = Layout::matrix;
  merge_free(member.free, free);
  if (slot.axis != 0 && tree[triple.id].op == Op::tuple) {
    member.id = tree.children(triple.id)[slot.axis - 1u];
    return member;
  }
  const ExprId axis = tree.add({.op = Op::basis, .rank = 1, .span = span}, {}, std::span(&slot, 1));
  const std::array factors{axis, triple.id};
  member.id = tree.add({.op = Op::dot, .rank = 2, .span = span}, factors);
  return member;
}

MaybeTyped of_each_member(Reading& reading, const Typed& triple, Span span,
                          const std::function<MaybeTyped(const Typed&)>& operation) {
  std::vector<Typed> members;
  for (std::uint8_t k = 1; k <= axes_of_space; ++k) {
    auto member = operation(member_along(reading.tree, triple, k, span));
    if (!member) return std::nullopt;
    members.push_back(*std::move(member));
  }
  return triple_made_of(reading.tree, members, span);
}

MaybeTyped dot_with_triple(Reading& reading, const Typed& left, const Typed& right, Span span) {
  if (is_triple(left) && is_triple(right)) return sum_of_products(reading, left, right, span);
  const Typed& vector = is_triple(left) ? right : left;
  const Typed& triple = is_triple(left) ? left : right;
  if (!fits_triple(reading, vector, triple, span)) return std::nullopt;
  note(reading, "a vector beside a vector of matrices has real components");
  Typed matrix = apply_op(reading.tree, Op::dot, span, 2, {vector, triple});
  matrix.layout = Layout::matrix;
  return matrix;
}

MaybeTyped cross_with_triple(Reading& reading, const Typed& left, const Typed& right, Span span) {
  ExprTree& tree = reading.tree;
  const bool both = is_triple(left) && is_triple(right);
  if (!both && !fits_triple(reading, is_triple(left) ? right : left, is_triple(left) ? left : right, span))
    return std::nullopt;
  if (both && tree[left.id].axes[1] != tree[right.id].axes[1])
    return unsupported(reading, span, "the matrices of both vectors have different sizes");
  std::vector<Typed> members;
  for (std::uint8_t i = 0; i < axes_of_space; ++i) {
    const auto j = static_cast<std::uint8_t>((i + 1) % axes_of_space + 1);
    const auto k = static_cast<std::uint8_t>((i + 2) % axes_of_space + 1);
    const auto there = product_along(reading, left, j, right, k, span);
    const auto back = product_along(reading, left, k, right, j, span);
    if (!there || !back) return std::nullopt;
    members.push_back(
        apply_op(tree, Op::add, span, 2, {*there, apply_op(tree, Op::negate, span, 2, {*back})}));
  }
  return triple_made_of(tree, members, span);
}

}  // namespace rigor
