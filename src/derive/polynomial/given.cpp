// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/given.h"

#include <algorithm>
#include <map>

#include "base/among.h"
#include "derive/polynomial/collected.h"
#include "derive/polynomial/contraction.h"

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
      const bool used = is_one_of(k, binding.factors);
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
    const bool known =
        wanted.kind == Kind::component || wanted.kind == Kind::delta || wanted.kind == Kind::epsilon;
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

  bool is_variable(IndexId index) const {
    return is_one_of(index, replacement_.indices) || is_one_of(index, replacement_.pattern.indices);
  }
  bool is_variable(ParticleId particle) const {
    return is_one_of(particle, replacement_.particles) || is_one_of(particle, replacement_.pattern.particles);
  }

  /// A letter that the pattern sums over is summed over here, and occurs nowhere else.
  bool sums_fit(const Binding& binding) const {
    for (const IndexId index : replacement_.pattern.indices) {
      const Slot& slot = binding.indices.at(index);
      if (slot.axis != 0 || !is_one_of(slot.variable, term_.indices) ||
          stands_elsewhere(slot.variable, binding))
        return false;
    }
    for (const ParticleId particle : replacement_.pattern.particles) {
      const auto bound = binding.particles.find(particle);
      if (bound == binding.particles.end() || !is_one_of(bound->second, term_.particles) ||
          stands_elsewhere(bound->second, binding))
        return false;
    }
    return true;
  }

  template <class Variable>
  bool stands_elsewhere(Variable variable, const Binding& binding) const {
    for (std::size_t k = 0; k < term_.factors.size(); ++k) {
      const auto place = std::ranges::find(binding.factors, k);
      const bool whole =
          place != binding.factors.end() &&
          term_.factors[k].exponent ==
              replacement_.pattern.factors[static_cast<std::size_t>(place - binding.factors.begin())]
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

/// The replacement fits what is opaque in the polynomial: used there, it would go deeper each time.
bool fits_inside(const ExprTree& tree, const Replacement& replacement, const IndexPolynomial& polynomial) {
  for (const IndexMonomial& term : polynomial.terms) {
    for (const IndexFactor& factor : term.factors) {
      if (factor.argument == nullptr) continue;
      for (const IndexMonomial& each : factor.argument->terms) {
        if (Matching(tree, replacement, each).find()) return true;
      }
      if (fits_inside(tree, replacement, *factor.argument)) return true;
    }
  }
  return false;
}

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

/// into − from, as one sum.
void gather(IndexPolynomial& into, const IndexPolynomial& from) {
  for (IndexMonomial term : from.terms) {
    term.coefficient = term.coefficient * SmallRational(-1);
    into.terms.push_back(std::move(term));
  }
}

/// How often a component is differentiated, by the time first.
int rank_of(const SymbolTable& symbols, const IndexFactor& factor) {
  if (factor.kind != Kind::component || factor.exponent != 1) return -1;
  const Symbol& symbol = symbols[factor.symbol];
  return 100 * symbol.order(By::time) + symbol.order(By::space);
}

/// c·x + rest = 0 as x = −rest/c, with x the component that is differentiated most and c free of sums.
bool solve_for_leading(const SymbolTable& symbols, IndexPolynomial& zero, IndexPolynomial& right) {
  std::size_t best_term = 0;
  std::size_t best_factor = 0;
  int best = -1;
  for (std::size_t t = 0; t < zero.terms.size(); ++t) {
    const IndexMonomial& term = zero.terms[t];
    if (!term.indices.empty() || !term.particles.empty()) continue;
    for (std::size_t f = 0; f < term.factors.size(); ++f) {
      if (rank_of(symbols, term.factors[f]) <= best) continue;
      best = rank_of(symbols, term.factors[f]);
      best_term = t;
      best_factor = f;
    }
  }
  if (best < 0) return false;
  IndexMonomial pivot = zero.terms[best_term];
  zero.terms.erase(zero.terms.begin() + static_cast<std::ptrdiff_t>(best_term));
  IndexMonomial inverse = pivot;
  inverse.coefficient = SmallRational(-1) / pivot.coefficient;
  inverse.factors.erase(inverse.factors.begin() + static_cast<std::ptrdiff_t>(best_factor));
  for (IndexFactor& factor : inverse.factors) {
    if (factor.kind == Kind::delta || factor.kind == Kind::epsilon) return false;
    factor.exponent = -factor.exponent;
  }
  const auto rest = product_of(zero, {{inverse}});
  if (!rest) return false;
  right = *rest;
  zero.terms = {IndexMonomial{.factors = {pivot.factors[best_factor]}}};
  return true;
}

}  // namespace

std::optional<Replacement> replacement_of(ExprTree& tree, const Equation& equation, Orientation orientation) {
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
  contract_deltas(*left);
  contract_deltas(*right);
  if (orientation == Orientation::leading) {
    gather(*left, *right);
    *left = collected(tree, *left);
    if (!solve_for_leading(tree.symbols, *left, *right)) return std::nullopt;
  }
  if (left->terms.size() != 1 && right->terms.size() == 1) std::swap(left, right);
  if (left->terms.empty()) std::swap(left, right);
  if (left->terms.empty() || left->terms[0].factors.empty()) return std::nullopt;
  result.pattern = left->terms[0];
  left->terms.erase(left->terms.begin());
  result.by = *right;
  gather(result.by, *left);
  result.inside = !fits_inside(tree, result, result.by);
  return result;
}

Replacement replacement_of_unit(ExprTree& tree, SymbolId unit) {
  Replacement result;
  IndexFactor component{.symbol = unit, .slots = {{.axis = 3}}, .exponent = 2};
  if (tree.symbols[unit].per_particle) {
    component.particle = tree.add_particle("");
    result.particles = {component.particle};
  }
  result.pattern.factors = {component};
  result.by.terms.push_back({});
  for (const std::uint8_t axis : {std::uint8_t{1}, std::uint8_t{2}}) {
    component.slots = {{.axis = axis}};
    result.by.terms.push_back({.coefficient = -1, .factors = {component}});
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
    const auto product =
        product_of({{rest_of(term, replacement, *binding)}}, put_in(tree, replacement, *binding));
    if (!product || ++uses > most_uses) return false;
    changed = true;
    open.insert(open.end(), product->terms.rbegin(), product->terms.rend());
  }
  if (!changed || result.terms.size() > most_monomials) return false;
  polynomial = std::move(result);
  return true;
}

}  // namespace rigor
