// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols and their definitions: the part of `evaluator.h`.
#pragma once

#include "algebra/evaluator/evaluator.h"
#include "base/check.h"

namespace rigor {

template <class Domain>
auto Evaluator<Domain>::symbol_component(const ExprNode& symbol, std::size_t component) -> Number {
  if (scope_->is_zeroed(symbol.symbol)) return Number{};
  const std::uint32_t particle = bound(symbol.particle);
  if (const Definition* definition = scope_->definition_of(symbol.symbol)) {
    return unfolded_component(*definition, particle, component);
  }
  if (scope_->is_circle_number(symbol.symbol)) return domain_->circle_number();
  if (particle == 0 && tree_->symbols[symbol.symbol].per_particle)
    throw Undecidable("a particle's quantity stands outside of its sum");  // a neighbour of a row may be so
  return domain_->value(symbol.symbol, particle, component);
}

template <class Domain>
auto Evaluator<Domain>::whole_symbol(const ExprNode& symbol) -> Array {
  Array value;
  const std::size_t count = component_count(tree_->symbols[symbol.symbol]);
  value.reserve(count);
  for (std::size_t i = 0; i < count; ++i) value.push_back(symbol_component(symbol, i));
  return value;
}

template <class Domain>
auto Evaluator<Domain>::value_of(const Definition& definition, std::uint32_t particle) -> Array {
  Array value;
  const std::size_t count = component_count(tree_->symbols[definition.symbol]);
  value.reserve(count);
  for (std::size_t i = 0; i < count; ++i) value.push_back(unfolded_component(definition, particle, i));
  return value;
}

template <class Domain>
auto Evaluator<Domain>::unfolded_component(const Definition& definition, std::uint32_t particle,
                                           std::size_t component) -> Number {
  const std::uint64_t key = (static_cast<std::uint64_t>(definition.symbol) << 32) | particle;
  const std::size_t count = component_count(tree_->symbols[definition.symbol]);
  if (const auto known = unfolded_.find(key); known != unfolded_.end() && known->second[component]) {
    return *known->second[component];
  }
  if (definition.indices.empty()) {
    Array all = inside(definition, particle, 0, [&] { return array(definition.body); });
    RIGOR_CHECK(all.size() == count, all.size(), count);
    if (is_rejected()) return Number{};
    for (Number& each : all) domain_->settle(each);
    auto& kept = unfolded_[key];
    kept.assign(all.begin(), all.end());
    return *kept[component];
  }
  Number value = inside(definition, particle, component, [&] { return scalar(definition.body); });
  if (is_rejected()) return Number{};
  domain_->settle(value);
  auto& kept = unfolded_[key];
  kept.resize(count);
  kept[component] = value;
  return value;
}

/// Z of `Z = \sum_s e^{-\beta E_s}` is the same number inside `\sum_s e^{-\beta E_s}/Z`: what speaks of no
/// particle is evaluated outside of all sums, where the domain tells the difference.
template <class Domain>
template <class Body>
auto Evaluator<Domain>::outside_sums(const Body& body) {
  if constexpr (requires { domain_->outside_sums(body); }) {
    return domain_->outside_sums(body);
  } else {
    return body();
  }
}

/// Runs `body` with the definition's variables bound, and restores what they were.
template <class Domain>
template <class Body>
auto Evaluator<Domain>::inside(const Definition& definition, std::uint32_t particle, std::size_t component,
                               const Body& body) {
  std::vector<std::uint8_t> before;
  for (const IndexId index : definition.indices) before.push_back(axis_[static_cast<std::size_t>(index)]);
  const std::uint32_t particle_before = bound(definition.particle);
  for (auto index = definition.indices.rbegin(); index != definition.indices.rend(); ++index) {
    const std::size_t dimension = tree_->space(*index).dimension;
    bind(*index, static_cast<std::uint8_t>(component % dimension + 1));
    component /= dimension;
  }
  if (definition.particle != no_particle) bind(definition.particle, particle);
  auto value = definition.particle == no_particle ? outside_sums(body) : body();
  for (std::size_t i = 0; i < before.size(); ++i) bind(definition.indices[i], before[i]);
  if (definition.particle != no_particle) bind(definition.particle, particle_before);
  return value;
}

}  // namespace rigor
