// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that others hold: is one still a counterexample?
#include <algorithm>
#include <utility>

#include "algebra/decide/decide.h"
#include "algebra/evaluator/components.h"
#include "algebra/parts/complex_sample.h"
#include "algebra/sample/refute.h"
#include "algebra/sample/sample_text.h"
#include "algebra/words/operator_question.h"
#include "algebra/words/sized_question.h"
#include "base/among.h"

namespace rigor {
namespace {

constexpr std::uint32_t most_particles = 100;  // a sample that we make has 6 at most

/// Puts the sample's values into a point; the symbol for which one is missing or does not fit, if any.
[[nodiscard]] std::optional<SymbolId> fill(SamplePoint& point, const ExprTree& tree, const Sample& sample) {
  for (const SymbolId symbol : point.symbols()) {
    const bool per_particle = tree.symbols[symbol].per_particle;
    const Meaning meaning = meaning_in(sample, symbol);
    point.mean(symbol, meaning);
    for (std::uint32_t p = per_particle ? 1 : 0; p <= (per_particle ? sample.particles : 0); ++p) {
      const auto value = std::ranges::find_if(sample.values, [&](const SampleValue& each) {
        return each.symbol == symbol && each.particle == p;
      });
      if (value == sample.values.end()) return symbol;
      const auto components = to_components(*value, tree.symbols[symbol], meaning);
      if (!components) return symbol;
      point.set_all(symbol, p, *components);
    }
  }
  return std::nullopt;
}

[[nodiscard]] bool fits(const ExprTree& tree, const Equation& claim, const Sample& sample) {
  const std::vector<std::uint8_t> dimensions = dimensions_of(tree, claim);
  const auto is_axis = [](std::uint8_t axis, std::uint8_t dimension) {
    return axis >= 1 && axis <= dimension;
  };
  const auto is_particle = [&](std::uint32_t particle) {
    return particle >= 1 && particle <= sample.particles;
  };
  return sample.axes.size() == dimensions.size() && sample.free_particles.size() == claim.particles.size() &&
         std::equal(sample.axes.begin(), sample.axes.end(), dimensions.begin(), is_axis) &&
         std::ranges::all_of(sample.free_particles, is_particle);
}

/// The position of the first assumption that does not hold on the point, or has no value there.
[[nodiscard]] std::optional<std::size_t> broken_assumption(const Question& question,
                                                           const std::vector<std::size_t>& positions,
                                                           SampleEvaluator& evaluator) {
  for (const std::size_t position : positions) {
    try {
      if (!evaluator.holds(question.assumptions[position])) return position;
    } catch (const PointRejected&) {
      return position;
    }
  }
  return std::nullopt;
}

/// Those that are written there, each once, left before right.
[[nodiscard]] std::vector<SymbolId> symbols_in_claim(const Question& question) {
  std::vector<SymbolId> symbols;
  for (const ExprId side : {question.claim.left, question.claim.right}) {
    for (const SymbolId symbol : symbols_in(*question.tree, side)) {
      if (!is_one_of(symbol, symbols)) symbols.push_back(symbol);
    }
  }
  return symbols;
}

[[nodiscard]] Replay fault(Replay::Fault kind) {
  Replay result;
  result.fault = kind;
  return result;
}

/// What a sample of complex values says of both parts. Its sides are those of the claim, put together.
[[nodiscard]] Replay replay_in_parts(const Question& question, const Sample& complex) {
  const RealQuestion real = in_real_parts(question);
  const Sample sample = with_parts(complex, real);
  const bool claim_in_parts = real.sides_in_parts && question.claim.relation == Relation::equal;
  const auto at = [&](const Question& of, std::uint8_t part, bool in_parts) {
    return replay_closely(of, in_parts ? at_part(sample, real, part) : sample);
  };
  Replay result = at(real.question, 1, claim_in_parts);
  if (result.fault != Replay::Fault::none || !real.sides_in_parts) return result;
  Question of_sides = real.question;
  of_sides.claim = real.sides;
  const Replay re = at(of_sides, 1, true);
  const Replay im = at(of_sides, 2, true);
  if (re.fault != Replay::Fault::none || im.fault != Replay::Fault::none)
    return fault(Replay::Fault::undefined);
  if (claim_in_parts) result.differ = re.differ || im.differ;
  result.sides = {complex_text(re.sides.left, im.sides.left), complex_text(re.sides.right, im.sides.right)};
  return result;
}

}  // namespace

Replay replay_closely(const Question& question, const Sample& sample) {
  if (is_about_operators(question)) {  // matrices have values, other operators none
    const auto at = at_size(question, std::max(rows_of_sample(*question.tree, sample), 1));
    if (!at || at->sized.empty()) return fault(Replay::Fault::undefined);
    return replay_closely(at->question, sized(sample, *at));
  }
  if (is_about_complex(question)) {
    try {
      return replay_in_parts(question, sample);
    } catch (const Undecidable&) {
      return fault(Replay::Fault::undefined);
    }
  }
  const Scope scope(question, Scope::Definitions::unfolded);
  const std::vector<std::size_t> assumptions = relevant_assumptions(scope);
  const Reach reached = reach_of_sample(scope, assumptions);
  if (reached.too_large) return fault(Replay::Fault::undefined);
  if (sample.particles > most_particles || reached.particles != (sample.particles > 0) ||
      !fits(scope.tree(), question.claim, sample))
    return fault(Replay::Fault::place);
  SamplePoint point(scope.tree(), reached.symbols, sample.particles);
  Replay result;
  if (const auto symbol = fill(point, scope.tree(), sample)) {
    result.fault = Replay::Fault::value;
    result.symbol = *symbol;
    return result;
  }
  SampleEvaluator evaluator(scope, Limits{});
  evaluator.enclose();
  try {
    evaluator.look_at(point);
    if (const auto broken = broken_assumption(question, assumptions, evaluator)) {
      result.fault = Replay::Fault::assumption;
      result.assumption = *broken;
      return result;
    }
    const Difference sides = evaluator.at(question.claim, {sample.axes, sample.free_particles});
    result.sides = {to_text(sides.left), to_text(sides.right)};
    result.differ = !is_related(sides.left, question.claim.relation, sides.right);
    return result;
  } catch (const PointRejected&) {
    return fault(Replay::Fault::undefined);
  } catch (const Undecidable&) {
    return fault(Replay::Fault::undefined);
  }
}

std::optional<SideValues> replay(const Question& question, const Sample& sample) {
  Replay result = replay_closely(question, sample);
  if (result.fault != Replay::Fault::none) return std::nullopt;
  return std::move(result.sides);
}

std::vector<SampleValue> following_values(const Question& question, const Sample& sample) {
  if (is_about_operators(question)) return {};
  if (is_about_complex(question)) {
    try {
      const RealQuestion real = in_real_parts(question);
      std::vector<SampleValue> values = following_values(real.question, with_parts(sample, real));
      for (SampleValue& value : values) value = with_complex_values(std::move(value), real);
      return values;
    } catch (const Undecidable&) {
      return {};
    }
  }
  const Scope scope(question, Scope::Definitions::unfolded);
  const Reach reached = reach_of_sample(scope, relevant_assumptions(scope));
  std::vector<SampleValue> values;
  if (reached.too_large) return values;
  SamplePoint point(scope.tree(), reached.symbols, sample.particles);
  if (fill(point, scope.tree(), sample)) return values;
  SampleEvaluator evaluator(scope, Limits{});
  evaluator.enclose();
  evaluator.look_at(point);
  for (const SymbolId symbol : symbols_in_claim(question)) {
    const Definition* definition = scope.is_zeroed(symbol) ? nullptr : scope.definition_of(symbol);
    if (definition == nullptr) continue;
    const bool per_particle = scope.tree().symbols[symbol].per_particle;
    for (std::uint32_t p = per_particle ? 1 : 0; p <= (per_particle ? sample.particles : 0); ++p) {
      try {
        SampleValue value{.symbol = symbol, .particle = p, .components = {}};
        for (const PointValue& each : evaluator.value_of(*definition, p))
          value.components.push_back(to_text(each));
        values.push_back(std::move(value));
      } catch (const PointRejected&) {
        // it has no rational value: the sides may have one all the same
      } catch (const Undecidable&) {
        return values;
      }
    }
  }
  return values;
}

std::vector<SymbolId> symbols_of_sample(const Question& question) {
  if (is_about_operators(question)) {
    const int stated = stated_rows(question);
    const auto at = at_size(question, stated == 0 ? 2 : stated);
    if (!at) return {};
    std::vector<SymbolId> symbols = symbols_of_sample(at->question);
    for (SymbolId& symbol : symbols) {
      for (const auto& [letter, made] : at->sized) symbol = symbol == made ? letter : symbol;
    }
    return symbols;
  }
  if (is_about_complex(question)) {
    try {
      return symbols_of_sample(in_real_parts(question).question);
    } catch (const Undecidable&) {
      return {};
    }
  }
  const Scope scope(question, Scope::Definitions::unfolded);
  return reach_of_sample(scope, relevant_assumptions(scope)).symbols;
}

}  // namespace rigor
