// SPDX-License-Identifier: GPL-3.0-or-later
// The operations one by one; products are in `compile_products.cpp`, symbols in `compile_symbols.cpp`.
#include "numeric/program/compile_walk.h"

#include <algorithm>

#include "base/check.h"
#include "numeric/program/library_function.h"

namespace rigor {
ExpressionCompiler::ExpressionCompiler(const ExprTree& tree, std::span<const Definition> definitions,
                                       Code& code)
    : tree_(&tree),
      definitions_(definitions),
      code_(&code),
      values_(code),
      axis_(tree.index_count(), 0),
      particle_(tree.particle_count(), unbound),
      symbols_(tree.symbols.size()) {
  stack_.reserve(64);
  for (std::size_t i = 0; i < definitions.size(); ++i)
    symbols_[static_cast<std::size_t>(definitions[i].symbol)].definition = static_cast<std::int32_t>(i);
}

void ExpressionCompiler::fail(std::string reason) {
  if (failure_.empty()) failure_ = std::move(reason);
}

/// Counts the work; false: there has been too much of it, or it nests too deeply.
bool ExpressionCompiler::enter() {
  if (++steps_ > most_steps || code_->values.size() > most_values || stack_.size() > 100 * largest_array)
    fail("the program would be too large");
  if (depth_ > deepest) fail("it nests too deeply");
  return failure_.empty();
}

void ExpressionCompiler::add(const ProgramRoot& root) {
  std::size_t count = 1;
  for (std::size_t i = 0; i < root.indices.size(); ++i) count *= 3;
  if (count > largest_array) return fail("it has too many free indices");
  for (std::size_t place = 0; place < count && failure_.empty(); ++place) {
    std::size_t rest = place;
    for (auto index = root.indices.rbegin(); index != root.indices.rend(); ++index, rest /= 3)
      axis_[static_cast<std::size_t>(*index)] = static_cast<std::uint8_t>(rest % 3 + 1);
    const std::size_t begin = array(root.expr);
    for (std::size_t i = begin; i < stack_.size() && failure_.empty(); ++i)
      code_->outputs.push_back(values_.value_of(stack_[i]));
    stack_.resize(begin);
  }
  for (const IndexId index : root.indices) axis_[static_cast<std::size_t>(index)] = 0;
}

Operand ExpressionCompiler::scalar(ExprId id) {
  if (!enter()) return ValueTable::zero;
  ++depth_;
  const Operand value = scalar_of(id);
  --depth_;
  return value;
}

Operand ExpressionCompiler::scalar_of(ExprId id) {
  const ExprNode& here = node(id);
  switch (here.op) {
    case Op::number:
      return values_.constant(tree_->digits(id));
    case Op::delta:
    case Op::epsilon: {
      const int sign = index_sign(id);
      return sign == 0 ? ValueTable::zero : sign > 0 ? ValueTable::one : ValueTable::minus_one;
    }
    case Op::symbol:
      return symbol_component(here, slot_position(id));
    case Op::add: {
      Operand total = ValueTable::zero;
      for (const ExprId each : tree_->children(id)) total = values_.add(total, scalar(each));
      return total;
    }
    case Op::negate:
      return ValueTable::negated(scalar(child(id)));
    case Op::multiply:
      return scalar_factors(id);
    case Op::divide: {
      if (const auto named = library_function(*tree_, id))
        return values_.unary(named->instruction, scalar(named->argument));
      const Operand dividend = scalar(child(id, 0));
      return values_.divide(dividend, scalar(child(id, 1)));
    }
    case Op::power:
      return scalar_power(id);
    case Op::real_power:
      fail("powers with such an exponent are not evaluated in floating point yet");
      return ValueTable::zero;
    case Op::root:
      return values_.unary(Instruction::root, scalar(child(id)));
    case Op::length:
      return values_.unary(Instruction::root, square_of_vector(child(id)));
    case Op::absolute:
      return values_.unary(Instruction::absolute, scalar(child(id)));
    case Op::function: {
      const Operand argument = scalar(child(id));
      switch (here.function) {
        case Function::sin:
          return values_.unary(Instruction::sin, argument);
        case Function::cos:
          return values_.unary(Instruction::cos, argument);
        case Function::exp:
          return values_.unary(Instruction::exp, argument);
        default:
          fail("logarithms and arcs are not evaluated in floating point yet");
          return ValueTable::zero;
      }
    }
    case Op::table:
      return table_entry(id);
    case Op::imaginary_unit:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
      fail("complex numbers are not evaluated in floating point yet");
      return ValueTable::zero;
    default: {
      const std::size_t begin = array(id);
      const Operand value = stack_.size() > begin ? stack_[begin] : ValueTable::zero;
      stack_.resize(begin);
      return value;
    }
  }
}

std::size_t ExpressionCompiler::array(ExprId id) {
  const std::size_t begin = stack_.size();
  if (!enter()) return begin;
  ++depth_;
  array_of(id);
  --depth_;
  return begin;
}

void ExpressionCompiler::array_of(ExprId id) {
  const ExprNode& here = node(id);
  const std::size_t begin = stack_.size();
  if (component_count(here.rank) > largest_array) return fail("a tensor has too many components");
  switch (here.op) {
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
      return fail("complex numbers are not evaluated in floating point yet");
    case Op::symbol:
      if (here.slot_count > 0) break;
      for (std::size_t i = 0; i < component_count(tree_->symbols[here.symbol].rank); ++i)
        stack_.push_back(symbol_component(here, i));
      return;
    case Op::basis:
      stack_.resize(begin + 3, ValueTable::zero);
      stack_[begin + slot_position(id)] = ValueTable::one;
      return;
    case Op::add:
      return add_arrays(id);
    case Op::negate:
      array(child(id));
      for (std::size_t i = begin; i < stack_.size(); ++i) stack_[i] = ValueTable::negated(stack_[i]);
      return;
    case Op::multiply:
      return outer_product(id);
    case Op::divide: {
      if (here.rank == 0) break;
      array(child(id, 0));
      const Operand divisor = scalar(child(id, 1));
      for (std::size_t i = begin; i < stack_.size(); ++i) stack_[i] = values_.divide(stack_[i], divisor);
      return;
    }
    case Op::dot:
      return contraction(id);
    case Op::cross:
      return cross_product(id);
    case Op::component: {
      array(child(id));
      const std::size_t at = begin + slot_position(id);
      if (at < stack_.size()) stack_[begin] = stack_[at];
      stack_.resize(std::min(stack_.size(), begin + 1));
      return;
    }
    case Op::tuple:
      for (const ExprId each : tree_->children(id)) array(each);
      return;
    case Op::determinant:
      return determinant(id);
    case Op::index_sum:
      return index_sum(id);
    case Op::particle_sum:
      return particle_sum(id);
    case Op::table:
      if (here.rank == 0) break;
      array(child(id, tree_->table(id).entry[slot_position(id)]));
      return;
    default:
      break;
  }
  const Operand value = scalar(id);
  stack_.push_back(value);
}

void ExpressionCompiler::add_arrays(ExprId id) {
  const std::size_t begin = stack_.size();
  for (const ExprId each : tree_->children(id)) {
    const std::size_t summand = array(each);
    if (summand == begin || !failure_.empty()) continue;
    for (std::size_t i = summand; i < stack_.size(); ++i)
      stack_[begin + i - summand] = values_.add(stack_[begin + i - summand], stack_[i]);
    stack_.resize(summand);
  }
}

/// The component that a node's slots pick, row by row; 0 where there are none.
std::size_t ExpressionCompiler::slot_position(ExprId id) {
  std::size_t position = 0;
  for (const Slot& slot : tree_->slots(id)) {
    RIGOR_CHECK(axis(slot) != 0, tree_->name(slot.variable));
    position = 3 * position + (axis(slot) - 1u);
  }
  return position;
}

/// δ or ε; an axis that is not bound yet is 0, and then 1 stands for "not known to be 0".
int ExpressionCompiler::index_sign(ExprId id) const {
  const auto slots = tree_->slots(id);
  const int i = axis(slots[0]);
  const int j = axis(slots[1]);
  if (node(id).op == Op::delta) return i == j || i == 0 || j == 0 ? 1 : 0;
  const int k = axis(slots[2]);
  if (i != 0 && j != 0 && k != 0) return (i - j) * (j - k) * (k - i) / 2;
  const bool repeated = (i != 0 && (i == j || i == k)) || (j != 0 && j == k);
  return repeated ? 0 : 1;
}

void ExpressionCompiler::index_sum(ExprId id) {
  const std::size_t total = stack_.size();
  const std::size_t count = component_count(node(id).rank);
  stack_.resize(total + count, ValueTable::zero);
  IndexChain chain;
  chain.first_variable = static_cast<std::uint32_t>(chain_variables_.size());
  const auto is_bound_here = [&](IndexId index) {
    const auto begin = chain_variables_.begin() + chain.first_variable;
    return std::find(begin, chain_variables_.end(), index) != chain_variables_.end();
  };
  while (node(id).op == Op::index_sum && !is_bound_here(node(id).index)) {
    chain_variables_.push_back(node(id).index);
    id = child(id);
  }
  chain.variables = static_cast<std::uint32_t>(chain_variables_.size()) - chain.first_variable;
  chain.body = id;
  while (node(id).op == Op::negate) id = child(id);
  if (node(id).op == Op::multiply) chain.factors = tree_->children(id);
  const auto variable = [&](std::uint32_t i) -> std::uint8_t& {
    return axis_[static_cast<std::size_t>(chain_variables_[chain.first_variable + i])];
  };
  std::vector<std::uint8_t> before;
  before.reserve(chain.variables);
  for (std::uint32_t i = 0; i < chain.variables; ++i) before.push_back(std::exchange(variable(i), 0));
  sum_chain(chain, 0, total, count);
  for (std::uint32_t i = 0; i < chain.variables; ++i) variable(i) = before[i];
  chain_variables_.resize(chain.first_variable);
}

void ExpressionCompiler::sum_chain(const IndexChain& chain, std::uint32_t level, std::size_t total,
                                   std::size_t count) {
  if (!enter()) return;
  if (level == chain.variables) {
    const std::size_t summand = array(chain.body);
    for (std::size_t i = 0; i < count && summand + i < stack_.size(); ++i)
      stack_[total + i] = values_.add(stack_[total + i], stack_[summand + i]);
    stack_.resize(summand);
    return;
  }
  const auto at = static_cast<std::size_t>(chain_variables_[chain.first_variable + level]);
  for (std::uint8_t value = 1; value <= 3; ++value) {
    axis_[at] = value;
    if (!is_left_out(chain.factors)) sum_chain(chain, level + 1, total, count);
  }
  axis_[at] = 0;
}

/// A number among a table's values is as good as one of ε's: 0 leaves its term out.
Operand ExpressionCompiler::table_entry(ExprId id) {
  const ExprId entry = child(id, tree_->table(id).entry[slot_position(id)]);
  const bool negative = node(entry).op == Op::negate;
  const ExprId size = negative ? child(entry) : entry;
  if (node(size).op == Op::number && tree_->digits(size) == "0") return ValueTable::zero;
  if (node(size).op == Op::number && tree_->digits(size) == "1")
    return negative ? ValueTable::minus_one : ValueTable::one;
  return scalar(entry);
}

}  // namespace rigor
