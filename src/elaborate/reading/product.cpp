// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/product.h"

#include <fmt/format.h>

#include <algorithm>

#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/summation.h"
#include "elaborate/reading/triple.h"
#include "expr/tree/state.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

struct Separated {
  std::vector<Typed> scalars = {};
  std::vector<Operand> vectors = {};
};

/// A quantity that is written in words, or a power of one: nobody says whether it is a vector, but words that
/// are multiplied (`\text{speed}\times\text{time}`) are numbers with units.
bool is_in_words(const ExprTree& tree, ExprId id) {
  if (tree[id].op == Op::power) id = tree.children(id)[0];
  return tree[id].op == Op::symbol && tree.symbols[tree[id].symbol].name.find("\\text{") == 0;
}

/// A number, π, or a number with units.
bool is_value(const ExprTree& tree, ExprId id) {
  return tree[id].rank == 0 && std::ranges::all_of(symbols_in(tree, id), [&](SymbolId each) {
           return tree.symbols[each].unit_of_measure.has_value() || tree.symbols[each].circle_number;
         });
}

/// A scalar between a product sign and a vector belongs to the vector: `\mathbf R\times m\mathbf V`.
std::optional<Separated> separate_scalars(Reading& reading, const std::vector<Operand>& operands) {
  const auto is_number = [&](const Typed& typed, bool after_scalar) {
    return reading.tree[typed.id].op == Op::number || (after_scalar && is_value(reading.tree, typed.id));
  };
  const auto is_dot = [&](const Typed& typed) { return reading.tree[typed.id].op == Op::dot; };
  Separated separated;
  auto& [scalars, vectors] = separated;
  Joint carried = Joint::none;
  const Operand* crossed = nullptr;  // a scalar that a `\times` leads to
  const Operand* previous = nullptr;
  for (const Operand& operand : operands) {
    const bool after_scalar = previous != nullptr && previous->typed.rank == 0;
    const bool by_words = after_scalar && (is_in_words(reading.tree, operand.typed.id) ||
                                           is_in_words(reading.tree, previous->typed.id));
    const bool by_number = is_number(operand.typed, after_scalar) ||
                           (after_scalar && is_number(previous->typed, true)) || by_words;
    const bool dotted = operand.joint == Joint::dot && previous != nullptr;
    const bool product_dotted =
        dotted && ((operand.typed.rank == 0 && previous->typed.rank == 1 && is_dot(operand.typed)) ||
                   (operand.typed.rank == 1 && after_scalar && is_dot(previous->typed)));
    if (product_dotted)
      return wrong_rank(reading, operand.joint_span, "a dot product of a vector and a scalar",
                        {"leave out `\\cdot` if a multiple is meant"});
    const bool joined = operand.joint == Joint::dot || operand.joint == Joint::cross;
    if (operand.typed.rank == 0) {
      if (joined) carried = operand.joint;
      if (operand.joint == Joint::cross && !by_number) crossed = &operand;
      scalars.push_back(operand.typed);
    } else {
      if (vectors.empty() && operand.joint == Joint::cross && after_scalar && !by_number)
        return wrong_rank(reading, operand.joint_span, "a cross product of a scalar and a vector",
                          {"write the product without `\\times`, or declare the scalar as a vector"});
      Joint joint = joined ? operand.joint : (carried != Joint::none ? carried : Joint::juxtaposed);
      if (vectors.empty()) joint = Joint::none;
      vectors.push_back({operand.typed, joint, operand.joint_span});
      carried = Joint::none;
      crossed = nullptr;
    }
    previous = &operand;
  }
  if (crossed == nullptr) return separated;
  const bool any_vector = !vectors.empty() && !is_in_words(reading.tree, crossed->typed.id);
  return fail(reading, any_vector ? DiagnosticKind::rank_mismatch : DiagnosticKind::ambiguous_reading,
              crossed->joint_span,
              any_vector ? "a cross product of a vector and a scalar"
                         : "`\\times` between scalars can be a product, or a cross product of vectors",
              {"bold or `\\vec` letters are vectors, and so is what `rigor: vector …` declares"});
}

/// a_1 b_2 − a_2 b_1
Typed cross_in_plane(ExprTree& tree, const Typed& left, const Typed& right, Span span) {
  const auto product = [&](std::uint8_t of_left, std::uint8_t of_right) {
    const Slot slots[] = {{of_left, {}}, {of_right, {}}};
    const ExprId factors[] = {component_of(tree, left.id, std::span(slots, 1)),
                              component_of(tree, right.id, std::span(slots + 1, 1))};
    return tree.add({.op = Op::multiply, .span = span}, factors);
  };
  const ExprId subtracted = product(2, 1);
  Typed typed;
  merge_letters(typed, left);
  merge_letters(typed, right);
  typed.id = sum_of(
      tree, {product(1, 2), tree.add({.op = Op::negate, .span = span}, std::span(&subtracted, 1))}, 0, span);
  return typed;
}

/// Multiplies what `joint` joins, from left to right.
std::optional<std::vector<Operand>> multiply(Reading& reading, std::vector<Operand> vectors, Joint joint) {
  const ExprTree& tree = reading.tree;
  const bool cross = joint == Joint::cross;
  for (std::size_t k = 1; k < vectors.size();) {
    if (vectors[k].joint != joint) {
      ++k;
      continue;
    }
    if (cross && k + 1 < vectors.size() && vectors[k + 1].joint == Joint::cross)
      return ambiguous(reading, vectors[k + 1].joint_span,
                       "a cross product is not associative, so `A × B × C` has two readings",
                       {"put one of the two products in brackets"});
    Typed& left = vectors[k - 1].typed;
    const Typed& right = vectors[k].typed;
    if (is_triple(left) || is_triple(right)) {
      const Span span = cover(tree[left.id].span, tree[right.id].span);
      const auto product =
          cross ? cross_with_triple(reading, left, right, span) : dot_with_triple(reading, left, right, span);
      if (!product) return std::nullopt;
      left = *product;
      vectors.erase(vectors.begin() + static_cast<std::ptrdiff_t>(k));
      continue;
    }
    if (cross && (left.rank != 1 || right.rank != 1))
      return unsupported(reading, vectors[k].joint_span, "a cross product with a tensor is not decided");
    if (!cross && (left.rank == 0 || right.rank == 0))
      return ambiguous(reading, vectors[k].joint_span, "`A · B · C` has two readings",
                       {"put one of the two products in brackets"});
    const Span span = cover(tree[left.id].span, tree[right.id].span);
    if (left.layout == Layout::column && right.layout == Layout::row)
      return ambiguous(reading, vectors[k].joint_span,
                       "a dot between a column and a row can be their number or their matrix");
    const Space space = tree[left.id].axes[left.rank - 1];
    if (space != tree[right.id].axes[0])
      return wrong_rank(reading, vectors[k].joint_span, "a product of vectors of different spaces");
    if (cross && space.dimension == 2) {
      left = cross_in_plane(reading.tree, left, right, span);
    } else if (cross && space != common_space) {
      return unsupported(reading, vectors[k].joint_span,
                         "the cross product belongs to three dimensions, and to the plane");
    } else {
      const int rank = cross ? 1 : left.rank + right.rank - 2;
      left = apply_op(reading.tree, cross ? Op::cross : Op::dot, span, rank, {left, right});
    }
    vectors.erase(vectors.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return vectors;
}

/// `\mathbf A\mathbf B` is a dyad of vectors; with bold letters for matrices it is their product.
void guess_dyad(Reading& reading, const std::vector<Operand>& vectors, Span span) {
  const SymbolTable& symbols = reading.tree.symbols;
  const bool undeclared = std::ranges::any_of(vectors, [&](const Operand& vector) {
    const ExprNode& node = reading.tree[vector.typed.id];
    return node.op == Op::tuple || (node.op == Op::symbol && !symbols[node.symbol].declared);
  });
  note(reading, "two vectors side by side are their dyad");
  if (!undeclared) return;
  reading.found.dyad = span;
  const bool hats = std::ranges::any_of(vectors, [&](const Operand& vector) {
    const ExprNode& node = reading.tree[vector.typed.id];
    return node.op == Op::symbol && symbols[node.symbol].name.starts_with("\\hat");
  });
  reading.found.guess =
      hats ? Obstacle{DiagnosticKind::ambiguous_reading,
                      "letters with hats side by side can be a dyad of vectors or a product of operators, "
                      "which are not decided with",
                      {}}
           : Obstacle{DiagnosticKind::ambiguous_reading,
                      "bold letters side by side can be a dyad of vectors or a product of matrices",
                      {"`rigor: vector …` says that they are vectors"}};
}

MaybeTyped outer_product(Reading& reading, std::vector<Typed> scalars, const std::vector<Operand>& vectors,
                         Span span) {
  const auto is_table = [](const Operand& vector) { return vector.typed.layout != Layout::none; };
  if (std::ranges::any_of(vectors, is_table)) {
    std::vector<Typed> factors;
    for (const Operand& vector : vectors) factors.push_back(vector.typed);
    return product_of_matrices(reading, std::move(scalars), factors, span);
  }
  int rank = 0;
  for (const Operand& vector : vectors) {
    const bool beside = rank > 0 && vector.typed.rank > 0;
    if (beside && rank + vector.typed.rank > 2) {
      return ambiguous(reading, reading.tree[vector.typed.id].span,
                       "a tensor next to a vector can be their contraction or their outer product",
                       {"write `\\cdot` for the contraction"});
    }
    if (beside) guess_dyad(reading, vectors, span);
    rank += vector.typed.rank;
    scalars.push_back(vector.typed);
  }
  if (scalars.size() == 1) return scalars[0];
  return apply_op(reading.tree, Op::multiply, span, rank, scalars);
}

/// `L_z\mathbf{p}`: scalars are put before vectors, which would change the order of operators.
bool mixes_operators(const Reading& reading, const std::vector<Operand>& operands) {
  const auto has = [&](bool vectors) {
    return std::ranges::any_of(operands, [&](const Operand& each) {
      return (each.typed.rank > 0) == vectors && has_operators(reading.tree, each.typed.id);
    });
  };
  return has(true) && has(false);
}

/// `\mathbf A\mathbf x`, where nothing shows that x is a column of any size.
bool mixes_unsized(const Reading& reading, const std::vector<Operand>& operands) {
  const bool vectors = std::ranges::any_of(operands, [](const Operand& each) { return each.typed.rank > 0; });
  return vectors && std::ranges::any_of(operands, [&](const Operand& each) {
           return each.typed.rank == 0 && is_unsized(reading.tree, each.typed.id) &&
                  unsized_shape(reading.tree, each.typed.id) != UnsizedShape::number;
         });
}

MaybeTyped without_slash(Reading& reading, const std::vector<Operand>& operands, Span span) {
  if (operands.size() == 1) return operands[0].typed;
  if (mixes_unsized(reading, operands))
    return unsupported(
        reading, span, "a product of a matrix of any size with a vector of three components is not read",
        {"\"the column $\\mathbf x$\" or `\\mathbf x^T` shows that it has any number of components"});
  std::vector<Typed> factors;
  for (const Operand& operand : operands) factors.push_back(operand.typed);
  auto letters = contraction_of(reading, factors);
  if (!letters) return std::nullopt;
  if (mixes_operators(reading, operands))
    return unsupported(reading, span, "a product of operators with a vector of operators is not read",
                       {"write it in components"});
  auto separated = separate_scalars(reading, operands);
  auto vectors = separated ? multiply(reading, std::move(separated->vectors), Joint::cross) : std::nullopt;
  if (vectors) vectors = multiply(reading, *std::move(vectors), Joint::dot);
  if (!vectors) return std::nullopt;
  auto result = outer_product(reading, std::move(separated->scalars), *vectors, span);
  if (!result) return std::nullopt;
  return summed(reading.tree, *std::move(result), *std::move(letters));
}

}  // namespace

MaybeTyped divide(Reading& reading, const Typed& dividend, const Typed& divisor, Span span) {
  if (divisor.rank != 0) {
    return wrong_rank(reading, reading.tree[divisor.id].span, "a vector or tensor is in a denominator",
                      {"divide by its length or by a component"});
  }
  if (!divisor.free.empty()) {
    return unsupported(reading, divisor.free[0].span,
                       fmt::format("the index `{}` in a denominator is not decided", divisor.free[0].letter));
  }
  const bool number =
      (is_unsized(reading.tree, divisor.id) &&
       unsized_shape(reading.tree, divisor.id) == UnsizedShape::number) ||
      (holds_states(reading.tree, divisor.id) && state_shape(reading.tree, divisor.id) == StateShape::number);
  if (has_operators(reading.tree, divisor.id) && !number)
    return ambiguous(reading, span, "the inverse of an operator can stand on either side",
                     {"write `A^{-1}` on its side"});
  return apply_op(reading.tree, Op::divide, span, dividend.rank, {dividend, divisor});
}

namespace {

MaybeTyped product_of_numbers(Reading& reading, std::vector<Operand> operands, Span span) {
  const ExprTree& tree = reading.tree;
  for (std::size_t k = 1; k < operands.size(); ++k) {
    if (operands[k].joint != Joint::slash) continue;
    Typed& before = operands[k - 1].typed;
    const Typed divisor = operands[k].typed;
    const bool numbers = tree[before.id].op == Op::number && tree[divisor.id].op == Op::number;
    const bool last = std::none_of(operands.begin() + static_cast<std::ptrdiff_t>(k + 1), operands.end(),
                                   [](const Operand& each) { return each.joint == Joint::slash; });
    if (!numbers && last && reading.rules.divides_by_all) {
      const std::vector<Operand> behind(operands.begin() + static_cast<std::ptrdiff_t>(k), operands.end());
      operands.resize(k);
      const auto below = without_slash(reading, behind, span);
      const auto above = below ? without_slash(reading, operands, span) : std::nullopt;
      return above ? divide(reading, *above, *below, span) : std::nullopt;
    }
    if (!numbers && k + 1 < operands.size()) {
      return ambiguous(reading, operands[k].joint_span, "what follows the divisor can belong to it or not",
                       {"write `\\frac{…}{…}` or a bracket"});
    }
    if (!numbers) {
      operands.resize(k);
      const auto dividend = without_slash(reading, operands, span);
      return dividend ? divide(reading, *dividend, divisor, span) : std::nullopt;
    }
    const auto quotient =
        divide(reading, before, divisor, cover(tree[before.id].span, tree[divisor.id].span));
    if (!quotient) return std::nullopt;
    before = *quotient;
    operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(k));
    --k;
  }
  return without_slash(reading, operands, span);
}

}  // namespace

MaybeTyped product_of(Reading& reading, std::vector<Operand> operands, Span span) {
  auto product = product_of_numbers(reading, operands, span);
  bool unit = false;
  for (Operand& operand : operands) {
    if (!operand.typed.with_unit || operand.typed.rank > 0) continue;
    unit = true;
    operand.typed.id = *operand.typed.with_unit;
  }
  if (!product || product->rank != 0 || !unit) return product;
  if (const auto multiple = product_of_numbers(reading, std::move(operands), span))
    product->with_unit = multiple->id;
  return product;
}

}  // namespace rigor
