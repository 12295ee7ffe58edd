// SPDX-License-Identifier: GPL-3.0-or-later
// Can the assumptions be met at all?
#include <numeric>

#include "algebra/decide/decide.h"
#include "algebra/engine/undecidable.h"
#include "algebra/parts/complex_sample.h"
#include "algebra/sample/refute.h"
#include "algebra/sample/sample_text.h"
#include "algebra/words/operator_question.h"

namespace rigor {
namespace {

constexpr std::uint32_t attempts_from_known = 16;  // all numbers of particles are among so many

class Search {
 public:
  Search(const Scope& scope, const Limits& limits)
      : scope_(scope),
        limits_(limits),
        solver_(scope, all_of(scope.question().assumptions)),
        reach_(reach(scope, sides_of(scope.question().assumptions))),
        evaluator_(scope, limits) {
    evaluator_.take_circle_number_as_rational();
  }

  /// With what is known put into each point that is drawn, and then without.
  [[nodiscard]] std::optional<Sample> run(const Sample& known) {
    if (reach_.too_large) return std::nullopt;
    if (!known.values.empty()) {
      if (auto found = look(attempts_from_known, &known)) return found;
    }
    return look(limits_.sample_attempts, nullptr);
  }

 private:
  [[nodiscard]] static std::vector<std::size_t> all_of(const std::vector<Equation>& assumptions) {
    std::vector<std::size_t> all(assumptions.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  [[nodiscard]] static std::vector<ExprId> sides_of(const std::vector<Equation>& assumptions) {
    std::vector<ExprId> sides;
    for (const Equation& each : assumptions) sides.insert(sides.end(), {each.left, each.right});
    return sides;
  }

  [[nodiscard]] std::optional<Sample> look(std::uint32_t attempts, const Sample* known) {
    SampleSequence sequence(scope_.tree(), reach_, solver_.has_particle_sums());
    for (std::uint32_t attempt = 0; attempt < attempts; ++attempt) {
      SamplePoint point = sequence.next();
      if (known != nullptr && !put(*known, point)) continue;
      try {
        if (!solver_.solve(evaluator_, point, attempt)) continue;
        Sample found;
        found.particles = point.particles();
        found.values = values_of(point, scope_.tree());
        return found;
      } catch (const PointRejected&) {
        // the next one
      } catch (const Undecidable&) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// False if the sample has another number of particles.
  [[nodiscard]] bool put(const Sample& known, SamplePoint& point) const {
    if (known.particles > 0 && point.particles() > 0 && known.particles != point.particles()) return false;
    for (const SampleValue& value : known.values) {
      const bool is_there = point.has(value.symbol) && (value.particle == 0 || point.particles() > 0);
      if (!is_there) continue;
      const Meaning meaning = meaning_in(known, value.symbol);
      const auto components = to_components(value, scope_.tree().symbols[value.symbol], meaning);
      if (!components) continue;
      point.mean(value.symbol, meaning);
      point.set_all(value.symbol, value.particle, *components);
    }
    return true;
  }

  const Scope& scope_;
  const Limits& limits_;
  AssumptionSolver solver_;
  Reach reach_;
  SampleEvaluator evaluator_;
};

}  // namespace

std::optional<Sample> satisfying_sample(const Question& question, const Sample& known, const Limits& limits) {
  if (question.assumptions.empty()) return Sample{};
  if (is_about_operators(question)) {
    // Operators have no values, so the sample is of the numbers beside them.
    Budget alone;
    Limits most = limits;
    if (most.budget == nullptr) most.budget = &alone;
    Question numbers;
    if (!operators_can_satisfy(question, most, numbers)) return std::nullopt;
    return satisfying_sample(numbers, known, most);
  }
  if (is_about_complex(question)) {
    try {
      const RealQuestion real = in_real_parts(question);
      auto found = satisfying_sample(real.question, with_parts(known, real), limits);
      return found ? std::optional(with_complex_values(*std::move(found), real)) : std::nullopt;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }
  const Scope scope(question, Scope::Definitions::unfolded);
  Budget own;
  Limits counted = limits;
  if (counted.budget == nullptr) counted.budget = &own;
  try {
    return Search(scope, counted).run(known);
  } catch (const Undecidable&) {
    return std::nullopt;  // it takes too much to look
  }
}

}  // namespace rigor
