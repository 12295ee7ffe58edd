// SPDX-License-Identifier: GPL-3.0-or-later
// The products of `evaluator.h`.
#pragma once

#include <algorithm>
#include <array>

#include "algebra/evaluator/evaluator.h"

namespace rigor {

/// ε or δ among the factors is 0: that leaves the term out, whatever the other factors are.
template <class Domain>
bool Evaluator<Domain>::is_left_out(ExprId id) const {
  return std::ranges::any_of(tree_->children(id), [this](ExprId factor) {
    const Op op = node(factor).op;
    return (op == Op::delta || op == Op::epsilon) && index_sign(factor) == 0;
  });
}

/// The product of the scalar factors. After a 0 they need only have a value.
template <class Domain>
auto Evaluator<Domain>::scalar_factors(ExprId id) -> Number {
  Number value = domain_->integer(1);
  for (const ExprId factor : tree_->children(id)) {
    if (node(factor).rank > 0) continue;
    if (domain_->is_zero(value)) {
      demand_value(factor);
    } else {
      value = domain_->multiply(value, scalar(factor));
    }
  }
  return value;
}

template <class Domain>
auto Evaluator<Domain>::outer_product(ExprId id) -> Array {
  if (is_left_out(id)) return Array(component_count(node(id)));
  Array value{scalar_factors(id)};
  const bool is_zero = domain_->is_zero(value.front());
  for (const ExprId factor : tree_->children(id)) {
    if (node(factor).rank == 0) continue;
    if (is_zero) {
      demand_value(factor);
      continue;
    }
    const Array right = array(factor);
    Array longer;
    longer.reserve(value.size() * right.size());
    for (const Number& a : value) {
      for (const Number& b : right) longer.push_back(domain_->multiply(a, b));
    }
    value = std::move(longer);
  }
  return is_zero ? Array(component_count(node(id))) : value;
}

/// What a scalar symbol's definition says, if that is all the symbol stands for.
template <class Domain>
const Definition* Evaluator<Domain>::plain_definition(ExprId id) const {
  const ExprNode& here = node(id);
  const bool plain = here.op == Op::symbol && here.particle == no_particle && here.slot_count == 0;
  return plain ? scope_->definition_of(here.symbol) : nullptr;
}

/// An even power needs no root that is known exactly, and none at all of what is defined by its square.
template <class Domain>
auto Evaluator<Domain>::scalar_power(ExprId id) -> Number {
  const int exponent = node(id).exponent;
  ExprId base = child(id);
  if (exponent % 2 == 0) {
    const Definition* definition = plain_definition(base);
    if (definition != nullptr && node(definition->body).op == Op::root) {
      base = definition->body;
      if (definition->by_square) return domain_->power(scalar(child(base)), exponent / 2);
    }
    switch (node(base).op) {
      case Op::root:
        return domain_->even_power_of_root(scalar(child(base)), exponent);
      case Op::length:
        return domain_->power(square_of_vector(array(child(base))), exponent / 2);
      case Op::absolute:
        return domain_->power(scalar(child(base)), exponent);
      default:
        break;
    }
  }
  return domain_->power(scalar(child(id)), exponent);
}

template <class Domain>
auto Evaluator<Domain>::square_of_vector(const Array& v) -> Number {
  Number total{};
  for (const Number& each : v) domain_->add(total, domain_->power(each, 2));
  return total;
}

/// (a·b)_{i…k…} = Σ_s a_{i…s} b_{s k…}
template <class Domain>
auto Evaluator<Domain>::contraction(ExprId id) -> Array {
  const Array a = array(child(id, 0));
  const Array b = array(child(id, 1));
  const std::size_t shared = node(child(id, 1)).axes[0].dimension;
  const std::size_t rows = a.size() / shared;
  const std::size_t columns = b.size() / shared;
  Array value(rows * columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      Number& total = value[row * columns + column];
      for (std::size_t s = 0; s < shared; ++s) {
        domain_->add(total, domain_->multiply(a[shared * row + s], b[s * columns + column]));
      }
    }
  }
  return value;
}

/// (a×b)_i = a_j b_k − a_k b_j for cyclic (i, j, k).
template <class Domain>
auto Evaluator<Domain>::cross_product(const Array& a, const Array& b) -> Array {
  Array value(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    Number subtracted = domain_->multiply(a[k], b[j]);
    domain_->negate(subtracted);
    value[i] = domain_->multiply(a[j], b[k]);
    domain_->add(value[i], subtracted);
  }
  return value;
}

/// Σ over cyclic (i, j, k) of a_1i (a_2j a_3k − a_2k a_3j); where a row is of vectors, so is the result.
template <class Domain>
auto Evaluator<Domain>::determinant(ExprId id) -> Array {
  std::array<Array, 9> entry;
  for (std::size_t i = 0; i < 9; ++i) entry[i] = array(child(id, i));
  Array total(component_count(node(id)));
  const auto add_term = [&](std::size_t i, std::size_t j, std::size_t k, bool odd) {
    Array term{domain_->integer(odd ? -1 : 1)};
    for (const Array& factor : {entry[i], entry[3 + j], entry[6 + k]}) {
      Array longer;
      for (const Number& a : term) {
        for (const Number& b : factor) longer.push_back(domain_->multiply(a, b));
      }
      term = std::move(longer);
    }
    add_to(total, term);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    add_term(i, (i + 1) % 3, (i + 2) % 3, false);
    add_term(i, (i + 2) % 3, (i + 1) % 3, true);
  }
  return total;
}

template <class Domain>
void Evaluator<Domain>::add_to(Array& total, const Array& summand) {
  for (std::size_t i = 0; i < total.size(); ++i) domain_->add(total[i], summand[i]);
}

template <class Domain>
auto Evaluator<Domain>::sum_over_particles(ExprId id) -> Array {
  const ParticleId variable = node(id).particle;
  const std::uint32_t before = bound(variable);
  Array total = domain_->particle_sum(component_count(node(id)), [&](std::uint32_t particle) {
    bind(variable, particle);
    return array(child(id));
  });
  bind(variable, before);
  return total;
}

}  // namespace rigor
