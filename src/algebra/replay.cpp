// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that others hold: is one still a counterexample, and can the assumptions be met at all?
#include <algorithm>
#include <numeric>
#include <utility>

#include "algebra/decide.h"
#include "algebra/refute.h"
#include "algebra/sample_rotation.h"

namespace rigor {
namespace {

/// What the sample's numbers for a scalar stand for: 0 is an angle and a logarithm, too.
[[nodiscard]] Meaning meaning_in(const Sample& sample, SymbolId symbol) {
  for (const SampleValue& value : sample.values) {
    if (value.symbol != symbol || value.components.size() != 1) continue;
    const auto read = read_number(value.components[0]);
    if (read && read->meaning.kind != Meaning::Kind::itself) return read->meaning;
  }
  return {};
}

/// The number that gives an angle or a logarithm; empty if the text is no such thing.
[[nodiscard]] std::optional<Rational> number_with(const std::string& text, const Meaning& meaning) {
  const auto read = read_number(text);
  if (!read) return std::nullopt;
  if (read->meaning == meaning) return read->number;
  if (read->meaning.kind != Meaning::Kind::itself || !cln::zerop(read->number)) return std::nullopt;
  return meaning.kind == Meaning::Kind::logarithm ? 1 : 0;
}

[[nodiscard]] std::optional<std::vector<Rational>> to_components(const SampleValue& value,
                                                                 const Symbol& symbol,
                                                                 const Meaning& meaning) {
  std::vector<Rational> components;
  for (const std::string& text : value.components) {
    const std::optional<Rational> number = number_with(text, meaning);
    if (!number) return std::nullopt;
    components.push_back(*number);
  }
  if (components.size() != component_count(symbol.rank)) return std::nullopt;
  if (symbol.unit) {
    const Rational square =
        components[0] * components[0] + components[1] * components[1] + components[2] * components[2];
    if (square != 1) return std::nullopt;
  }
  if (symbol.rotation && !is_rotation(components)) return std::nullopt;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i] != components[canonical_component(symbol, i)]) return std::nullopt;
  }
  return components;
}

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

bool satisfiable(const Question& question, const Limits& limits) {
  if (question.assumptions.empty()) return true;
  const Scope scope(question, Scope::Definitions::unfolded);
  std::vector<std::size_t> all(question.assumptions.size());
  std::iota(all.begin(), all.end(), 0u);
  const AssumptionSolver solver(scope, all);
  std::vector<ExprId> roots;
  for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
  const Reach reached = reach(scope, roots);
  if (reached.too_large) return false;
  SampleSequence sequence(scope.tree(), reached, solver.has_particle_sums());
  SampleEvaluator evaluator(scope, limits);
  for (std::uint32_t attempt = 0; attempt < limits.sample_attempts; ++attempt) {
    SamplePoint point = sequence.next();
    try {
      if (solver.solve(evaluator, point, attempt)) return true;
    } catch (const PointRejected&) {
      // the next one
    } catch (const Undecidable&) {
      return false;
    }
  }
  return false;
}

}  // namespace rigor
