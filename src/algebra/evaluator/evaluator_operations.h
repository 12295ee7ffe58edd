// SPDX-License-Identifier: GPL-3.0-or-later
// The operations of `evaluator.h`, one by one, and the index variables.
#pragma once

#include "algebra/evaluator/evaluator.h"
#include "base/among.h"
#include "base/check.h"

#include <algorithm>

namespace rigor {

template <class Domain>
auto Evaluator<Domain>::scalar(ExprId id) -> Number {
  if (is_rejected()) return Number{};
  const Level level(depth_);
  domain_->step();
  const ExprNode& here = node(id);
  switch (here.op) {
    case Op::number:
      return domain_->number(tree_->digits(id));
    case Op::delta:
    case Op::epsilon:
      return domain_->integer(index_sign(id));
    case Op::symbol:
      return symbol_component(here, slot_position(id));
    case Op::add: {
      Number total{};
      for (const ExprId each : tree_->children(id)) domain_->add(total, scalar(each));
      return total;
    }
    case Op::negate: {
      Number value = scalar(child(id));
      domain_->negate(value);
      return value;
    }
    case Op::multiply:
      return is_left_out(id) ? Number{} : scalar_factors(id);
    case Op::divide:
      return domain_->divide(scalar(child(id, 0)), scalar(child(id, 1)));
    case Op::power:
      return scalar_power(id);
    case Op::real_power:
      return domain_->real_power(scalar(child(id, 0)), scalar(child(id, 1)));
    case Op::root:
      return domain_->root(scalar(child(id)));
    case Op::length:
      return domain_->root(square_of_vector(array(child(id))));
    case Op::absolute:
      return domain_->root(domain_->power(scalar(child(id)), 2));
    case Op::component:
      return array(child(id))[slot_position(id)];
    case Op::index_sum: {
      Number total{};
      const IndexChain chain = index_chain(id);
      for_each_index(chain, [&] { domain_->add(total, scalar(chain.body)); });
      return total;
    }
    case Op::function:
      return domain_->function(here.function, scalar(child(id)));
    case Op::imaginary_unit:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:  // `in_real_parts` leaves none of them
      throw Undecidable("complex numbers are not evaluated here");
    case Op::transpose:
    case Op::trace:
    case Op::matrix_determinant:  // `at_size` leaves none of them
      throw Undecidable("matrices of unknown size are not evaluated here");
    case Op::table:
      return scalar(child(id, tree_->table(id).entry[slot_position(id)]));
    case Op::basis:
    case Op::dot:
    case Op::cross:
    case Op::tuple:
    case Op::determinant:
    case Op::particle_sum:
      return array(id)[0];
  }
  return Number{};
}

template <class Domain>
auto Evaluator<Domain>::array(ExprId id) -> Array {
  const ExprNode& here = node(id);
  const bool always_array = here.op == Op::dot || here.op == Op::determinant || here.op == Op::particle_sum;
  if (here.rank == 0 && !always_array) return {scalar(id)};
  if (is_rejected()) return Array(component_count(here));
  const Level level(depth_);
  domain_->step();
  switch (here.op) {
    case Op::symbol:
      return whole_symbol(here);
    case Op::basis: {
      Array unit(component_count(here));
      unit[axis(tree_->slots(id)[0]) - 1u] = domain_->integer(1);
      return unit;
    }
    case Op::add: {
      Array total(component_count(here));
      for (const ExprId each : tree_->children(id)) add_to(total, array(each));
      return total;
    }
    case Op::negate: {
      Array value = array(child(id));
      for (Number& each : value) domain_->negate(each);
      return value;
    }
    case Op::multiply:
      return outer_product(id);
    case Op::divide: {
      Array value = array(child(id, 0));
      const Number divisor = scalar(child(id, 1));
      for (Number& each : value) each = domain_->divide(each, divisor);
      return value;
    }
    case Op::dot:
      return contraction(id);
    case Op::cross:
      return cross_product(array(child(id, 0)), array(child(id, 1)));
    case Op::tuple: {
      Array value;
      for (const ExprId each : tree_->children(id)) {
        for (Number& component : array(each)) value.push_back(std::move(component));
      }
      return value;
    }
    case Op::determinant:
      return determinant(id);
    case Op::index_sum: {
      Array total(component_count(here));
      const IndexChain chain = index_chain(id);
      for_each_index(chain, [&] { add_to(total, array(chain.body)); });
      return total;
    }
    case Op::particle_sum:
      return sum_over_particles(id);
    case Op::table:
      return array(child(id, tree_->table(id).entry[slot_position(id)]));
    default:
      return {scalar(id)};
  }
}

// --- index variables

/// Of the space that a slot runs over: that of the axis which it picks, or, in a table, its own.
template <class Domain>
std::size_t Evaluator<Domain>::dimension_at(ExprId id, std::size_t slot) const {
  const ExprNode& here = node(id);
  const auto axis = static_cast<int>(slot);
  if (here.op == Op::symbol) return tree_->symbols[here.symbol].axes[axis].dimension;
  if (here.op == Op::component) return node(child(id)).axes[axis].dimension;
  const Slot& own = tree_->slots(id)[slot];
  return own.axis == 0 ? tree_->space(own.variable).dimension : common_space.dimension;
}

/// The component that a node's slots pick, row by row; 0 where there are none.
template <class Domain>
std::size_t Evaluator<Domain>::slot_position(ExprId id) const {
  const auto slots = tree_->slots(id);
  std::size_t position = 0;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    RIGOR_CHECK(axis(slots[k]) != 0, tree_->name(slots[k].variable));
    position = dimension_at(id, k) * position + (axis(slots[k]) - 1u);
  }
  return position;
}

/// δ or ε; an axis that is not bound yet is 0, and then 1 stands for "not known to be 0".
template <class Domain>
int Evaluator<Domain>::index_sign(ExprId id) const {
  const auto slots = tree_->slots(id);
  const int i = axis(slots[0]);
  const int j = axis(slots[1]);
  if (node(id).op == Op::delta) return i == j || i == 0 || j == 0 ? 1 : 0;
  const int k = axis(slots[2]);
  if (i != 0 && j != 0 && k != 0) return permutation_sign(i, j, k);
  const bool repeated = (i != 0 && (i == j || i == k)) || (j != 0 && j == k);
  return repeated ? 0 : 1;
}

template <class Domain>
auto Evaluator<Domain>::index_chain(ExprId id) const -> IndexChain {
  IndexChain chain;
  const auto is_bound_here = [&](IndexId index) { return is_one_of(index, chain.variables); };
  while (node(id).op == Op::index_sum && !is_bound_here(node(id).index)) {
    chain.variables.push_back(node(id).index);
    id = child(id);
  }
  chain.body = id;
  while (node(id).op == Op::negate) id = child(id);
  if (node(id).op != Op::multiply) return chain;
  for (const ExprId factor : tree_->children(id)) {
    if (node(factor).op == Op::delta || node(factor).op == Op::epsilon) chain.guards.push_back(factor);
  }
  return chain;
}

template <class Domain>
template <class Term>
void Evaluator<Domain>::for_each_index(const IndexChain& chain, const Term& term) {
  std::vector<std::uint8_t> before;
  for (const IndexId index : chain.variables) {
    before.push_back(axis_[static_cast<std::size_t>(index)]);
    bind(index, 0);
  }
  for_each_value(chain, 0, term);
  for (std::size_t i = 0; i < before.size(); ++i) bind(chain.variables[i], before[i]);
}

template <class Domain>
template <class Term>
void Evaluator<Domain>::for_each_value(const IndexChain& chain, std::size_t level, const Term& term) {
  if (level == chain.variables.size()) {
    term();
    return;
  }
  const std::uint8_t dimension = tree_->space(chain.variables[level]).dimension;
  for (std::uint8_t value = 1; value <= dimension; ++value) {
    domain_->step();
    bind(chain.variables[level], value);
    if (is_rejected()) break;
    const bool vanishes =
        std::ranges::any_of(chain.guards, [this](ExprId guard) { return index_sign(guard) == 0; });
    if (!vanishes) for_each_value(chain, level + 1, term);
  }
  bind(chain.variables[level], 0);
}

}  // namespace rigor
