// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/counterexample.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algebra/decide.h"

namespace rigor {
namespace {

tl::unexpected<Error> does_not_fit(std::string reason) {
  return tl::make_unexpected(Error{std::move(reason)});
}

/// The claim's axes and particles, of which the description names the indices.
Result<Sample> placed(const Question& question, const Counterexample& example) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  const std::size_t axes = claim.indices.size() + static_cast<std::size_t>(tree[claim.left].rank);
  Sample sample;
  sample.particles = example.particles;
  if (example.component.size() != axes + claim.particles.size())
    return does_not_fit("the sample's component does not fit the step");
  for (std::size_t k = 0; k < example.component.size(); ++k) {
    const auto& [index, value] = example.component[k];
    const bool is_particle = k >= axes;
    const std::string expected = is_particle                ? tree.name(claim.particles[k - axes])
                                 : k < claim.indices.size() ? tree.name(claim.indices[k])
                                                            : "";
    const int most = is_particle ? static_cast<int>(example.particles) : 3;
    if (index != expected || value < 1 || value > most)
      return does_not_fit("the sample's component does not fit the step");
    if (is_particle) {
      sample.free_particles.push_back(static_cast<std::uint32_t>(value));
    } else {
      sample.axes.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return sample;
}

}  // namespace

Counterexample describe(const ExprTree& tree, const Equation& claim, const Sample& sample) {
  Counterexample example;
  example.particles = sample.particles;
  for (const SampleValue& value : sample.values) {
    const Symbol& symbol = tree.symbols[value.symbol];
    example.values.push_back({symbol.name, value.particle, symbol.rank, value.components});
  }
  for (std::size_t k = 0; k < sample.axes.size(); ++k) {
    const std::string index = k < claim.indices.size() ? tree.name(claim.indices[k]) : "";
    example.component.push_back({index, sample.axes[k]});
  }
  for (std::size_t k = 0; k < sample.free_particles.size() && k < claim.particles.size(); ++k) {
    example.component.push_back({tree.name(claim.particles[k]), static_cast<int>(sample.free_particles[k])});
  }
  example.left = sample.left;
  example.right = sample.right;
  return example;
}

Result<Sample> sample_of(const Question& question, const Counterexample& example) {
  Result<Sample> sample = placed(question, example);
  if (!sample) return sample;
  std::vector<bool> taken(example.values.size(), false);
  for (const SymbolId id : symbols_of_sample(question)) {
    const Symbol& symbol = question.tree->symbols[id];
    const std::uint32_t last = symbol.per_particle ? example.particles : 0;
    for (std::uint32_t particle = symbol.per_particle ? 1 : 0; particle <= last; ++particle) {
      std::size_t k = 0;
      while (k < taken.size() &&
             (taken[k] || example.values[k].symbol != symbol.name || example.values[k].rank != symbol.rank ||
              example.values[k].particle != particle))
        ++k;
      if (k == taken.size())
        return does_not_fit(fmt::format("the sample has no value of rank {} for `{}`{}", symbol.rank,
                                        symbol.name,
                                        particle > 0 ? fmt::format(" of particle {}", particle) : ""));
      taken[k] = true;
      sample->values.push_back({id, particle, example.values[k].components});
    }
  }
  const auto extra = std::find(taken.begin(), taken.end(), false);
  if (extra == taken.end()) return sample;
  const auto& value = example.values[static_cast<std::size_t>(extra - taken.begin())];
  return does_not_fit(fmt::format("the step does not depend on `{}`", value.symbol));
}

}  // namespace rigor
