// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that others hold: is one still a counterexample?
#include <algorithm>

#include "algebra/decide.h"
#include "algebra/refute.h"
#include "algebra/sample_text.h"

namespace rigor {
namespace {

/// The sample's values for the symbols that a statement needs; empty if one is missing or does not fit its
/// symbol.
[[nodiscard]] std::optional<SamplePoint> to_point(const ExprTree& tree, std::span<const SymbolId> symbols,
                                                  const Sample& sample) {
  SamplePoint point(tree, symbols, sample.particles);
  for (const SymbolId symbol : symbols) {
    const bool per_particle = tree.symbols[symbol].per_particle;
    const Meaning meaning = meaning_in(sample, symbol);
    point.mean(symbol, meaning);
    for (std::uint32_t p = per_particle ? 1 : 0; p <= (per_particle ? sample.particles : 0); ++p) {
      const auto value =
          std::find_if(sample.values.begin(), sample.values.end(),
                       [&](const SampleValue& each) { return each.symbol == symbol && each.particle == p; });
      if (value == sample.values.end()) return std::nullopt;
      const auto components = to_components(*value, tree.symbols[symbol], meaning);
      if (!components) return std::nullopt;
      point.set_all(symbol, p, *components);
    }
  }
  return point;
}

[[nodiscard]] bool fits(const ExprTree& tree, const Equation& claim, const Sample& sample) {
  const std::size_t axes = claim.indices.size() + tree[claim.left].rank;
  const auto is_axis = [](std::uint8_t axis) { return axis >= 1 && axis <= 3; };
  const auto is_particle = [&](std::uint32_t particle) {
    return particle >= 1 && particle <= sample.particles;
  };
  return sample.axes.size() == axes && sample.free_particles.size() == claim.particles.size() &&
         std::all_of(sample.axes.begin(), sample.axes.end(), is_axis) &&
         std::all_of(sample.free_particles.begin(), sample.free_particles.end(), is_particle);
}

}  // namespace

std::optional<SideValues> replay(const Question& question, const Sample& sample) {
  const Scope scope(question, Scope::Definitions::unfolded);
  if (!fits(scope.tree(), question.claim, sample)) return std::nullopt;
  const AssumptionSolver solver(scope, relevant_assumptions(scope));
  const Reach reached = reach_of_sample(scope, solver.assumptions());
  const std::optional<SamplePoint> point = to_point(scope.tree(), reached.symbols, sample);
  if (!point || reached.too_large) return std::nullopt;
  SampleEvaluator evaluator(scope, Limits{});
  try {
    if (!solver.holds(evaluator, *point)) return std::nullopt;
    const Difference sides = evaluator.at(question.claim, {sample.axes, sample.free_particles});
    return SideValues{to_text(sides.left), to_text(sides.right)};
  } catch (const PointRejected&) {
    return std::nullopt;
  } catch (const Undecidable&) {
    return std::nullopt;
  }
}

}  // namespace rigor
