// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols, their definitions, and whose particle they are.
#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "base/check.h"
#include "numeric/program/compile_walk.h"

namespace rigor {
namespace {

constexpr Operand not_asked = 0xffffffffu;
constexpr Operand being_unfolded = 0xfffffffeu;

}  // namespace

/// Which particle a variable is. One that nothing binds is a free particle of the program.
std::uint32_t ExpressionCompiler::bound(ParticleId id) {
  if (id == no_particle) return InputParticle::none;
  std::uint32_t& particle = particle_[static_cast<std::size_t>(id)];
  if (particle == unbound) {
    particle = InputParticle::first_free + static_cast<std::uint32_t>(code_->free_particles.size());
    code_->free_particles.push_back(id);
  }
  return particle;
}

/// The particle variables below a sum that are bound outside it, or free. A definition has only its own.
const std::vector<ParticleId>& ExpressionCompiler::others_in(ExprId sum) {
  for (const SumParticles& known : sums_) {
    if (known.sum == sum) return known.others;
  }
  SumParticles found{.sum = sum, .others = {}};
  std::vector<ParticleId> own{node(sum).particle};
  for (const ExprId at : nodes_below(*tree_, {child(sum)})) {
    const ExprNode& here = node(at);
    if (here.op == Op::particle_sum) own.push_back(here.particle);
    if (here.op == Op::symbol && here.particle != no_particle) found.others.push_back(here.particle);
  }
  std::ranges::sort(found.others);
  found.others.erase(std::unique(found.others.begin(), found.others.end()), found.others.end());
  std::erase_if(found.others, [&](ParticleId id) { return is_one_of(id, own); });
  sums_.push_back(std::move(found));
  return sums_.back().others;
}

/// Where a symbol's components for one particle are kept.
std::uint32_t ExpressionCompiler::components_of(SymbolId symbol, std::uint32_t particle, std::size_t count) {
  SymbolState& state = symbols_[static_cast<std::size_t>(symbol)];
  for (std::uint32_t at = state.known; at != 0; at = known_[at - 1].next) {
    if (known_[at - 1].particle == particle) return known_[at - 1].first;
  }
  const auto first = static_cast<std::uint32_t>(known_components_.size());
  known_components_.resize(first + count, not_asked);
  known_.push_back({symbol, particle, first, state.known});
  state.known = static_cast<std::uint32_t>(known_.size());
  return first;
}

Operand ExpressionCompiler::symbol_component(const ExprNode& symbol, std::size_t component) {
  const std::uint32_t particle = bound(symbol.particle);
  const std::int32_t at = symbols_[static_cast<std::size_t>(symbol.symbol)].definition;
  if (at < 0) return free_component(symbol, particle, component);
  return unfolded(definitions_[static_cast<std::size_t>(at)], particle, component);
}

Operand ExpressionCompiler::free_component(const ExprNode& symbol, std::uint32_t particle,
                                           std::size_t component) {
  const Symbol& what = tree_->symbols[symbol.symbol];
  if (what.noncommuting) fail("operators are not evaluated in floating point");
  if (what.complex) fail("complex numbers are not evaluated in floating point yet");
  const auto canonical = static_cast<std::uint32_t>(canonical_component(what, component));
  SymbolState& state = symbols_[static_cast<std::size_t>(symbol.symbol)];
  if (state.first_input == 0) {
    const std::size_t count = component_count(what.rank);
    if (count > largest_array) {
      fail("a tensor has too many components");
      return ValueTable::zero;
    }
    state.first_input = static_cast<std::uint32_t>(input_of_.size()) + 1;
    input_of_.resize(input_of_.size() + count, 0);
  }
  std::uint32_t& input = input_of_[state.first_input - 1 + canonical];
  if (input == 0) {
    code_->inputs.push_back({symbol.symbol, canonical, symbol.particle != no_particle});
    input = static_cast<std::uint32_t>(code_->inputs.size());
  }
  return values_.input(input - 1, particle);
}

Operand ExpressionCompiler::unfolded(const Definition& definition, std::uint32_t particle,
                                     std::size_t component) {
  const std::size_t count = component_count(tree_->symbols[definition.symbol].rank);
  const std::uint32_t first = components_of(definition.symbol, particle, count);
  const Operand known = known_components_[first + component];
  if (known == being_unfolded)
    fail(fmt::format("the definitions of `{}` are circular", tree_->symbols[definition.symbol].name));
  if (known == being_unfolded || !failure_.empty()) return ValueTable::zero;
  if (known != not_asked) return known;
  if (definition.indices.empty()) {
    for (std::size_t i = 0; i < count; ++i) known_components_[first + i] = being_unfolded;
    inside(definition, particle, 0, [&] {
      const std::size_t begin = array(definition.body);
      RIGOR_CHECK(!failure_.empty() || stack_.size() - begin == count, stack_.size() - begin, count);
      for (std::size_t i = 0; i < count && begin + i < stack_.size(); ++i)
        known_components_[first + i] = stack_[begin + i];
      stack_.resize(begin);
    });
  } else {
    known_components_[first + component] = being_unfolded;
    inside(definition, particle, component, [&] {
      const Operand value = scalar(definition.body);
      known_components_[first + component] = value;
    });
  }
  return failure_.empty() ? known_components_[first + component] : ValueTable::zero;
}

/// Runs `body` with the definition's variables bound, and restores what they were.
template <class Body>
void ExpressionCompiler::inside(const Definition& definition, std::uint32_t particle, std::size_t component,
                                const Body& body) {
  std::vector<std::uint8_t> before;
  before.reserve(definition.indices.size());
  for (auto index = definition.indices.rbegin(); index != definition.indices.rend(); ++index) {
    std::uint8_t& axis = axis_[static_cast<std::size_t>(*index)];
    before.push_back(std::exchange(axis, static_cast<std::uint8_t>(component % 3 + 1)));
    component /= 3;
  }
  std::uint32_t particle_before = unbound;
  const auto own = static_cast<std::size_t>(definition.particle);
  if (definition.particle != no_particle) particle_before = std::exchange(particle_[own], particle);
  body();
  if (definition.particle != no_particle) particle_[own] = particle_before;
  std::size_t at = 0;
  for (auto index = definition.indices.rbegin(); index != definition.indices.rend(); ++index)
    axis_[static_cast<std::size_t>(*index)] = before[at++];
}

}  // namespace rigor
