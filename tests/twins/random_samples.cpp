// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_samples.h"

#include <set>
#include <string>

#include "algebra/sample/refute.h"
#include "algebra/sample/sample_text.h"

namespace rigor {
namespace {

constexpr std::uint32_t attempts_for_each = 4;
constexpr std::uint32_t patience = 200;  // attempts without a sample

[[nodiscard]] std::string text_of(const Sample& sample) {
  std::string text = std::to_string(sample.particles);
  for (const SampleValue& value : sample.values) {
    for (const std::string& component : value.components) text += ' ' + component;
  }
  return text;
}

}  // namespace

RandomSamples try_random_samples(const Question& question, std::uint32_t wanted, std::uint64_t seed,
                                 const Limits& limits) {
  const Scope scope(question, Scope::Definitions::unfolded);
  AssumptionSolver solver(scope, relevant_assumptions(scope));
  const Reach reached = reach_of_sample(scope, solver.assumptions());
  RandomSamples result;
  if (reached.too_large) return result;
  SampleEvaluator evaluator(scope, limits);
  SampleSequence sequence(scope.tree(), reached, solver.has_particle_sums(), seed);
  std::set<std::string> seen;
  std::uint32_t in_vain = 0;
  while (result.compared < wanted && sequence.drawn() < wanted * attempts_for_each && in_vain < patience) {
    const std::uint32_t attempt = sequence.drawn();
    SamplePoint point = sequence.next();
    ++in_vain;
    try {
      if (!solver.none() && !solver.solve(evaluator, point, attempt)) continue;
      evaluator.look_at(point);
      const std::optional<Difference> difference = evaluator.difference(question.claim);
      Sample sample;
      sample.particles = point.particles();
      sample.values = values_of(point, scope.tree());
      if (!seen.insert(text_of(sample)).second) continue;
      ++result.compared;
      in_vain = 0;
      if (!difference) continue;
      sample.left = to_text(difference->left);
      sample.right = to_text(difference->right);
      result.failed = std::move(sample);
      return result;
    } catch (const PointRejected&) {
      // the next one
    } catch (const Undecidable&) {
      return result;
    }
  }
  return result;
}

}  // namespace rigor
