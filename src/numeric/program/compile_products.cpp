// SPDX-License-Identifier: GPL-3.0-or-later
// Products, powers and sums over particles.
#include <algorithm>
#include <array>

#include "numeric/program/compile_walk.h"

namespace rigor {

/// ε or δ among the factors is 0: that leaves the term out, whatever the other factors are.
bool ExpressionCompiler::is_left_out(std::span<const ExprId> factors) const {
  return std::ranges::any_of(factors, [this](ExprId factor) {
    const Op op = node(factor).op;
    return (op == Op::delta || op == Op::epsilon) && index_sign(factor) == 0;
  });
}

/// The product of the scalar factors, from left to right.
Operand ExpressionCompiler::scalar_factors(ExprId id) {
  if (is_left_out(tree_->children(id))) return ValueTable::zero;
  Operand value = ValueTable::one;
  for (const ExprId factor : tree_->children(id)) {
    if (node(factor).rank == 0 && value != ValueTable::zero) value = values_.multiply(value, scalar(factor));
  }
  return value;
}

/// First the scalar factors, then the components of the others.
void ExpressionCompiler::outer_product(ExprId id) {
  const std::size_t begin = stack_.size();
  const Operand scale = scalar_factors(id);
  stack_.push_back(scale);
  for (const ExprId factor : tree_->children(id)) {
    if (node(factor).rank == 0) continue;
    const std::size_t right = array(factor);
    const std::size_t left_count = right - begin;
    const std::size_t right_count = stack_.size() - right;
    if (left_count * right_count > largest_array) return fail("a tensor has too many components");
    for (std::size_t i = 0; i < left_count; ++i) {
      for (std::size_t j = 0; j < right_count; ++j) {
        const Operand product = values_.multiply(stack_[begin + i], stack_[right + j]);
        stack_.push_back(product);
      }
    }
    stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(begin),
                 stack_.begin() + static_cast<std::ptrdiff_t>(right + right_count));
  }
}

/// What a scalar symbol's definition says, if that is all the symbol stands for.
const Definition* ExpressionCompiler::plain_definition(ExprId id) const {
  const ExprNode& here = node(id);
  if (here.op != Op::symbol || here.particle != no_particle || here.slot_count != 0) return nullptr;
  const std::int32_t at = symbols_[static_cast<std::size_t>(here.symbol)].definition;
  return at < 0 ? nullptr : &definitions_[static_cast<std::size_t>(at)];
}

/// An even power of a root, a length or an absolute value is a power of the square.
Operand ExpressionCompiler::scalar_power(ExprId id) {
  const int exponent = node(id).exponent;
  if (exponent > 1000 || exponent < -1000) {
    fail("an exponent is too large");
    return ValueTable::zero;
  }
  ExprId base = child(id);
  if (exponent % 2 == 0) {
    const Definition* definition = plain_definition(base);
    if (definition != nullptr && node(definition->body).op == Op::root) base = definition->body;
    switch (node(base).op) {
      case Op::root:
        return values_.power(scalar(child(base)), exponent / 2);
      case Op::length:
        return values_.power(square_of_vector(child(base)), exponent / 2);
      case Op::absolute:
        return values_.power(scalar(child(base)), exponent);
      default:
        break;
    }
  }
  return values_.power(scalar(child(id)), exponent);
}

Operand ExpressionCompiler::square_of_vector(ExprId id) {
  const std::size_t begin = array(id);
  Operand total = ValueTable::zero;
  for (std::size_t i = begin; i < stack_.size(); ++i)
    total = values_.add(total, values_.multiply(stack_[i], stack_[i]));
  stack_.resize(begin);
  return total;
}

/// (a·b)_{i…k…} = Σ_s a_{i…s} b_{s k…}
void ExpressionCompiler::contraction(ExprId id) {
  const std::size_t a = array(child(id, 0));
  const std::size_t b = array(child(id, 1));
  if (!failure_.empty()) return;
  const std::size_t end = stack_.size();
  const std::size_t rows = (b - a) / 3;
  const std::size_t columns = (end - b) / 3;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      Operand total = ValueTable::zero;
      for (std::size_t s = 0; s < 3; ++s)
        total =
            values_.add(total, values_.multiply(stack_[a + 3 * row + s], stack_[b + s * columns + column]));
      stack_.push_back(total);
    }
  }
  stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(a),
               stack_.begin() + static_cast<std::ptrdiff_t>(end));
}

/// (a×b)_i = a_j b_k − a_k b_j for cyclic (i, j, k).
void ExpressionCompiler::cross_product(ExprId id) {
  const std::size_t a = array(child(id, 0));
  const std::size_t b = array(child(id, 1));
  if (!failure_.empty()) return;
  std::array<Operand, 3> value{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Operand plus = values_.multiply(stack_[a + j], stack_[b + k]);
    const Operand minus = values_.multiply(stack_[a + k], stack_[b + j]);
    value[i] = values_.add(plus, ValueTable::negated(minus));
  }
  stack_.resize(a);
  stack_.insert(stack_.end(), value.begin(), value.end());
}

/// Σ over cyclic (i, j, k) of a_1i a_2j a_3k − a_1i a_2k a_3j; where a row is of vectors, so is the result.
void ExpressionCompiler::determinant(ExprId id) {
  const std::size_t begin = stack_.size();
  std::array<std::size_t, 10> entry{};
  for (std::size_t i = 0; i < 9; ++i) entry[i] = array(child(id, i));
  entry[9] = stack_.size();
  if (!failure_.empty()) return;
  const std::size_t count = node(id).rank == 0 ? 1 : 3;
  std::array<Operand, 3> total{};
  const auto factor = [&](std::size_t at, std::size_t component) {
    return stack_[entry[at] + (entry[at + 1] - entry[at] == 1 ? 0 : component)];
  };
  const auto add_term = [&](std::size_t i, std::size_t j, std::size_t k, bool odd) {
    for (std::size_t c = 0; c < count; ++c) {
      const Operand two = values_.multiply(factor(i, c), factor(3 + j, c));
      const Operand term = values_.multiply(two, factor(6 + k, c));
      total[c] = values_.add(total[c], odd ? ValueTable::negated(term) : term);
    }
  };
  for (std::size_t i = 0; i < 3; ++i) {
    add_term(i, (i + 1) % 3, (i + 2) % 3, false);
    add_term(i, (i + 2) % 3, (i + 1) % 3, true);
  }
  stack_.resize(begin);
  stack_.insert(stack_.end(), total.begin(), total.begin() + static_cast<std::ptrdiff_t>(count));
}

void ExpressionCompiler::particle_sum(ExprId id) {
  std::uint32_t level = 1;
  for (const ParticleId other : others_in(id)) {
    const std::uint32_t at = bound(other);
    if (at < InputParticle::first_free) level = std::max(level, at + 1);
  }
  if (level > deepest_level) return fail("sums over particles nest too deeply");
  const auto variable = static_cast<std::size_t>(node(id).particle);
  const std::uint32_t before = particle_[variable];
  particle_[variable] = level;
  const std::size_t begin = array(child(id));
  particle_[variable] = before;
  for (std::size_t i = begin; i < stack_.size(); ++i)
    stack_[i] = values_.sum(stack_[i], static_cast<int>(level));
}

}  // namespace rigor
