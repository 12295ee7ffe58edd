// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/given.h"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

constexpr int most_uses = 60;
constexpr std::size_t most_trials = 4000;  // of factors, for one monomial

/// What the pattern's letters are in the monomial.
struct Binding {
  std::map<IndexId, Slot> indices = {};
  std::map<ParticleId, ParticleId> particles = {};
  std::vector<std::size_t> factors = {};  // positions, one for each factor of the pattern
};

bool same_slot(const Slot& a, const Slot& b) {
  return a.axis == b.axis && (a.axis != 0 || a.variable == b.variable);
}

class Matching {
 public:
  Matching(const ExprTree& tree, const Replacement& replacement, const IndexMonomial& term)
      : tree_(tree), replacement_(replacement), term_(term) {}

  std::optional<Binding> find() {
    Binding binding;
    if (!extend(binding)) return std::nullopt;
    return binding;
  }

 private:
  bool extend(Binding& binding) {
    const std::size_t next = binding.factors.size();
    if (next == replacement_.pattern.factors.size()) return sums_fit(binding);
    const IndexFactor& wanted = replacement_.pattern.factors[next];
    for (std::size_t k = 0; k < term_.factors.size(); ++k) {
      if (++trials_ > most_trials) return false;
      const bool used =
          std::find(binding.factors.begin(), binding.factors.end(), k) != binding.factors.end();
      if (used || !same_head(wanted, term_.factors[k])) continue;
      for (const bool swapped : {false, true}) {
        if (swapped && !can_swap(wanted)) break;
        Binding longer = binding;
        if (!bind(wanted, term_.factors[k], swapped, longer)) continue;
        longer.factors.push_back(k);
        if (!extend(longer)) continue;
        binding = std::move(longer);
        return true;
      }
    }
    return false;
  }

  static bool same_head(const IndexFactor& wanted, const IndexFactor& found) {
    const bool known = wanted.kind == Kind::component || wanted.kind == Kind::delta || wanted.kind == Kind::epsilon;
    if (!known || wanted.kind != found.kind || wanted.slots.size() != found.slots.size()) return false;
    if (wanted.kind == Kind::component && wanted.symbol != found.symbol) return false;
    return wanted.exponent > 0 ? found.exponent >= wanted.exponent : found.exponent <= wanted.exponent;
  }

  bool can_swap(const IndexFactor& factor) const {
    return factor.slots.size() == 2 &&
           (factor.kind == Kind::delta ||
            (factor.kind == Kind::component && tree_.symbols[factor.symbol].symmetric));
  }

  bool bind(const IndexFactor& wanted, const IndexFactor& found, bool swapped, Binding& binding) const {
    for (std::size_t k = 0; k < wanted.slots.size(); ++k) {
      const Slot& other = found.slots[swapped ? 1 - k : k];
      if (!bind(wanted.slots[k], other, binding)) return false;
    }
    if (wanted.particle == no_particle) return true;
    const auto [entry, fresh] = binding.particles.try_emplace(wanted.particle, found.particle);
    if (!is_variable(wanted.particle)) return wanted.particle == found.particle;
    return fresh || entry->second == found.particle;
  }

  bool bind(const Slot& wanted, const Slot& found, Binding& binding) const {
    if (wanted.axis != 0) return wanted.axis == found.axis;
    if (!is_variable(wanted.variable)) return same_slot(wanted, found);
    const auto [entry, fresh] = binding.indices.try_emplace(wanted.variable, found);
    return fresh || same_slot(entry->second, found);
  }

  template <class Variable>
  static bool is_among(const std::vector<Variable>& all, Variable variable) {
    return std::find(all.begin(), all.end(), variable) != all.end();
  }
  bool is_variable(IndexId index) const {
    return is_among(replacement_.indices, index) || is_among(replacement_.pattern.indices, index);
  }
  bool is_variable(ParticleId particle) const {
    return is_among(replacement_.particles, particle) || is_among(replacement_.pattern.particles, particle);
  }

  /// What the pattern sums over is summed over here, and stands nowhere else.
  bool sums_fit(const Binding& binding) const {
    for (const IndexId index : replacement_.pattern.indices) {
      const Slot& slot = binding.indices.at(index);
      if (slot.axis != 0 || !is_among(term_.indices, slot.variable) || stands_elsewhere(slot.variable, binding))
        return false;
    }
    for (const ParticleId particle : replacement_.pattern.particles) {
      const auto bound = binding.particles.find(particle);
      if (bound == binding.particles.end() || !is_among(term_.particles, bound->second) ||
          stands_elsewhere(bound->second, binding))
        return false;
    }
    return true;
  }

  template <class Variable>
  bool stands_elsewhere(Variable variable, const Binding& binding) const {
    for (std::size_t k = 0; k < term_.factors.size(); ++k) {
      const auto place = std::find(binding.factors.begin(), binding.factors.end(), k);
      const bool whole = place != binding.factors.end() &&
                         term_.factors[k].exponent ==
                             replacement_.pattern
                                 .factors[static_cast<std::size_t>(place - binding.factors.begin())]
                                 .exponent;
      if (!whole && speaks_of(term_.factors[k], variable)) return true;
    }
    return false;
  }

  const ExprTree& tree_;
  const Replacement& replacement_;
  const IndexMonomial& term_;
  std::size_t trials_ = 0;
};

/// The monomial without what was matched.
IndexMonomial rest_of(const IndexMonomial& term, const Replacement& replacement, const Binding& binding) {
  IndexMonomial rest = term;
  for (std::size_t k = 0; k < binding.factors.size(); ++k)
    rest.factors[binding.factors[k]].exponent -= replacement.pattern.factors[k].exponent;
  std::erase_if(rest.factors, [](const IndexFactor& factor) { return factor.exponent == 0; });
  rest.coefficient = rest.coefficient / replacement.pattern.coefficient;
  for (const IndexId index : replacement.pattern.indices)
    std::erase(rest.indices, binding.indices.at(index).variable);
  for (const ParticleId particle : replacement.pattern.particles)
    std::erase(rest.particles, binding.particles.at(particle));
  return rest;
}

IndexPolynomial put_in(ExprTree& tree, const Replacement& replacement, const Binding& binding) {
  IndexPolynomial by;
  for (const IndexMonomial& each : replacement.by.terms) {
    IndexMonomial term = with_new_sums(tree, each);
    for (const auto& [variable, slot] : binding.indices) replace_index(term, variable, slot);
    for (const auto& [variable, particle] : binding.particles) replace_particle(term, variable, particle);
    by.terms.push_back(std::move(term));
  }
  return by;
}

}  // namespace

std::optional<Replacement> replacement_of(ExprTree& tree, const Equation& equation) {
  if (equation.relation != Relation::equal) return std::nullopt;
  Replacement result;
  result.indices = equation.indices;
  result.particles = equation.particles;
  std::vector<Slot> slots;
  for (int axis = 0; axis < tree[equation.left].rank; ++axis) {
    result.indices.push_back(tree.add_index(""));
    slots.push_back({0, result.indices.back()});
  }
  auto left = polynomial_of(tree, equation.left, slots);
  auto right = polynomial_of(tree, equation.right, slots);
  if (!left || !right) return std::nullopt;
  if (left->terms.size() != 1 && right->terms.size() == 1) std::swap(left, right);
  if (left->terms.empty()) std::swap(left, right);
  if (left->terms.empty() || left->terms[0].factors.empty()) return std::nullopt;
  result.pattern = left->terms[0];
  result.by = *right;
  for (std::size_t k = 1; k < left->terms.size(); ++k) {
    IndexMonomial other = left->terms[k];
    other.coefficient = other.coefficient * SmallRational(-1);
    result.by.terms.push_back(std::move(other));
  }
  return result;
}

bool replace_given(ExprTree& tree, const Replacement& replacement, IndexPolynomial& polynomial) {
  bool changed = false;
  IndexPolynomial result;
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  int uses = 0;
  while (!open.empty()) {
    const IndexMonomial term = std::move(open.back());
    open.pop_back();
    const auto binding = Matching(tree, replacement, term).find();
    if (!binding) {
      result.terms.push_back(term);
      continue;
    }
    const auto product = product_of({{rest_of(term, replacement, *binding)}}, put_in(tree, replacement, *binding));
    if (!product || ++uses > most_uses) return false;
    changed = true;
    open.insert(open.end(), product->terms.rbegin(), product->terms.rend());
  }
  if (!changed || result.terms.size() > most_monomials) return false;
  polynomial = std::move(result);
  return true;
}

}  // namespace rigor
