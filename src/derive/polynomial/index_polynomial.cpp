// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/index_polynomial.h"

#include <algorithm>

namespace rigor {
namespace {

bool is_variable(const Slot& slot, IndexId variable) { return slot.axis == 0 && slot.variable == variable; }

void replace_index(IndexFactor& factor, IndexId variable, const Slot& by);
void replace_particle(IndexFactor& factor, ParticleId variable, ParticleId by);

/// What is opaque is shared, so that it is copied where it changes.
template <class Replace>
void in_argument(IndexFactor& factor, const Replace& replace) {
  if (factor.argument == nullptr) return;
  IndexPolynomial changed = *factor.argument;
  for (IndexMonomial& term : changed.terms) {
    for (IndexFactor& inner : term.factors) replace(inner);
  }
  factor.argument = std::make_shared<const IndexPolynomial>(std::move(changed));
}

void replace_index(IndexFactor& factor, IndexId variable, const Slot& by) {
  for (Slot& slot : factor.slots) {
    if (is_variable(slot, variable)) slot = by;
  }
  in_argument(factor, [&](IndexFactor& inner) { replace_index(inner, variable, by); });
}

void replace_particle(IndexFactor& factor, ParticleId variable, ParticleId by) {
  if (factor.particle == variable) factor.particle = by;
  in_argument(factor, [&](IndexFactor& inner) { replace_particle(inner, variable, by); });
}

template <class Variable>
bool speaks_in_argument(const IndexFactor& factor, Variable variable) {
  if (factor.argument == nullptr) return false;
  for (const IndexMonomial& term : factor.argument->terms) {
    for (const IndexFactor& inner : term.factors) {
      if (speaks_of(inner, variable)) return true;
    }
  }
  return false;
}

}  // namespace

bool speaks_of(const IndexFactor& factor, IndexId variable) {
  return std::ranges::any_of(factor.slots, [&](const Slot& slot) { return is_variable(slot, variable); }) ||
         speaks_in_argument(factor, variable);
}

bool speaks_of(const IndexFactor& factor, ParticleId variable) {
  return factor.particle == variable || speaks_in_argument(factor, variable);
}

void replace_index(IndexMonomial& monomial, IndexId variable, const Slot& by) {
  for (IndexFactor& factor : monomial.factors) {
    if (speaks_of(factor, variable)) replace_index(factor, variable, by);
  }
}

void replace_particle(IndexMonomial& monomial, ParticleId variable, ParticleId by) {
  for (IndexFactor& factor : monomial.factors) {
    if (speaks_of(factor, variable)) replace_particle(factor, variable, by);
  }
}

std::size_t occurrences(const IndexMonomial& monomial, IndexId variable) {
  std::size_t count = 0;
  for (const IndexFactor& factor : monomial.factors) {
    for (const Slot& slot : factor.slots) count += is_variable(slot, variable) ? 1 : 0;
    // inside of what is opaque it cannot be renamed by a δ alone: counted as too often
    if (speaks_in_argument(factor, variable)) count += 3;
  }
  return count;
}

IndexMonomial with_new_sums(ExprTree& tree, const IndexMonomial& monomial) {
  IndexMonomial result = monomial;
  for (IndexId& index : result.indices) {
    const IndexId fresh = tree.add_index(std::string(tree.name(index)));
    replace_index(result, index, {0, fresh});
    index = fresh;
  }
  for (ParticleId& particle : result.particles) {
    const ParticleId fresh = tree.add_particle(std::string(tree.name(particle)));
    replace_particle(result, particle, fresh);
    particle = fresh;
  }
  return result;
}

std::optional<IndexPolynomial> product_of(const IndexPolynomial& a, const IndexPolynomial& b) {
  if (a.terms.size() * b.terms.size() > most_monomials) return std::nullopt;
  IndexPolynomial result;
  for (const IndexMonomial& left : a.terms) {
    for (const IndexMonomial& right : b.terms) {
      IndexMonomial term = left;
      term.coefficient = left.coefficient * right.coefficient;
      term.indices.insert(term.indices.end(), right.indices.begin(), right.indices.end());
      term.particles.insert(term.particles.end(), right.particles.begin(), right.particles.end());
      term.factors.insert(term.factors.end(), right.factors.begin(), right.factors.end());
      if (!term.coefficient.is_valid() || term.factors.size() > most_factors) return std::nullopt;
      if (!term.coefficient.is_zero()) result.terms.push_back(std::move(term));
    }
  }
  return result;
}

}  // namespace rigor
