// SPDX-License-Identifier: GPL-3.0-or-later
#include "agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "algebra/decide/decide.h"
#include "exact_sample.h"
#include "numeric/body/body_letters.h"
#include "numeric/family/families.h"
#include "numeric/measure/assumptions.h"
#include "numeric/measure/bounds.h"
#include "numeric/program/program.h"

namespace rigor::agreement {
namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr double assumed_uncertainty = 16 * unit_roundoff;  // of numbers that meet assumptions to rounding
constexpr std::size_t sample_count = 16;

Program compiled(const ExprTree& tree, const Question& question, ExprId side,
                 std::span<const IndexId> indices) {
  const ProgramRoot root{side, indices};
  auto program = Program::compile(tree, question.definitions, std::span(&root, 1));
  if (!program) throw std::runtime_error(program.error().reason);
  return std::move(*program);
}

struct Sides {
  Program left;
  Program right;
  Sides(const ExprTree& tree, const Question& question, const Equation& equation)
      : left(compiled(tree, question, equation.left, equation.indices)),
        right(compiled(tree, question, equation.right, equation.indices)) {}
};

/// Which particle each of a program's free variables is.
std::vector<std::uint32_t> places(const Program& program, const Equation& equation,
                                  std::span<const std::uint32_t> particles) {
  std::vector<std::uint32_t> at;
  for (const ParticleId variable : program.free_particles()) {
    const auto found = std::find(equation.particles.begin(), equation.particles.end(), variable);
    if (found == equation.particles.end())
      throw std::runtime_error("a particle that the claim does not have");
    at.push_back(particles[static_cast<std::size_t>(found - equation.particles.begin())]);
  }
  return at;
}

Finding relate(Relation relation, double left, double right, double bound) {
  if (!std::isfinite(left) || !std::isfinite(right) || !std::isfinite(bound)) return Finding::open;
  const double distance = right - left;
  const bool apart = std::abs(distance) > bound;
  switch (relation) {
    case Relation::equal:
      return apart ? Finding::not_related : Finding::related;
    case Relation::unequal:
      return apart ? Finding::related : Finding::open;
    case Relation::less:
    case Relation::less_or_equal:
      if (!apart) return relation == Relation::less ? Finding::open : Finding::related;
      return distance > 0 ? Finding::related : Finding::not_related;
  }
  return Finding::open;
}

Finding compare_outputs(const Sides& sides, const Equation& equation, const Samples& samples,
                        double uncertainty, std::span<const std::uint32_t> particles,
                        std::optional<std::size_t> only, std::string& detail) {
  const auto left_at = places(sides.left, equation, particles);
  const auto right_at = places(sides.right, equation, particles);
  const BoundedResults left = evaluate_with_bounds(sides.left, samples, uncertainty, left_at);
  const BoundedResults right = evaluate_with_bounds(sides.right, samples, uncertainty, right_at);
  const std::size_t outputs = sides.left.outputs();
  if (sides.right.outputs() != outputs) throw std::runtime_error("the sides differ in rank");
  Finding whole = equation.relation == Relation::unequal ? Finding::open : Finding::related;
  for (std::size_t output = 0; output < outputs; ++output) {
    if (only && *only != output) continue;
    for (std::size_t sample = 0; sample < samples.samples(); ++sample) {
      const std::size_t l = output * samples.samples() + sample;
      const std::size_t r = output * samples.samples() + sample;
      const double bound = left.bounds[l] + right.bounds[r];
      const Finding found = relate(equation.relation, left.values[l], right.values[r], bound);
      if (found == Finding::not_related || (only && found != Finding::related)) {
        detail = fmt::format("component {}, sample {}: left {:.17g}, right {:.17g}, bound {:.3g}", output + 1,
                             sample + 1, left.values[l], right.values[r], bound);
        return found;
      }
      if (equation.relation == Relation::unequal && found == Finding::related) whole = Finding::related;
      if (found == Finding::open) whole = Finding::open;
    }
  }
  return whole;
}

}  // namespace

Finding compare(const ExprTree& tree, const Question& question, const Samples& samples, double uncertainty,
                std::string& detail) {
  const Equation& claim = question.claim;
  const Sides sides(tree, question, claim);
  if (!claim.particles.empty() && samples.particles() == 0) return Finding::related;
  Finding whole = Finding::related;
  const std::size_t particles = claim.particles.empty() ? 1 : samples.particles();
  for (std::uint32_t particle = 0; particle < particles; ++particle) {
    const std::vector<std::uint32_t> at(claim.particles.size(), particle);
    const Finding found = compare_outputs(sides, claim, samples, uncertainty, at, std::nullopt, detail);
    if (found == Finding::not_related) return found;
    if (found == Finding::open) whole = found;
  }
  return whole;
}

Finding compare_at_sample(const ExprTree& tree, const Question& question, const Sample& sample,
                          std::string& detail) {
  const Sides sides(tree, question, question.claim);
  std::size_t component = 0;
  for (const std::uint8_t axis : sample.axes) component = 3 * component + axis - 1u;
  std::vector<std::uint32_t> particles;
  for (const std::uint32_t particle : sample.free_particles) particles.push_back(particle - 1);
  return compare_outputs(sides, question.claim, samples_of(tree, sample), unit_roundoff, particles, component,
                         detail);
}

bool meets_assumptions(const ExprTree& tree, const Question& question, const Samples& samples,
                       double uncertainty) {
  return meets_all(tree, question.definitions, question.assumptions, samples, uncertainty);
}

Trials trials_for(const ExprTree& tree, const Question& question, std::span<const Body> bodies) {
  Trials trials;
  std::vector<Program> programs;
  std::vector<Equation> equations = question.assumptions;
  equations.push_back(question.claim);
  for (const Equation& equation : equations) {
    for (const ExprId side : {equation.left, equation.right})
      programs.push_back(compiled(tree, question, side, equation.indices));
  }
  std::vector<const Program*> pointers;
  for (const Program& program : programs) pointers.push_back(&program);
  const std::vector<SymbolId> symbols = symbols_read(pointers);
  Question with_tree = question;
  with_tree.tree = &tree;
  if (const auto exact = satisfying_sample(with_tree)) {
    // what no assumption speaks of is free
    DrawOptions options{.samples = 1, .seed = 7};
    if (exact->particles > 0) options.particles = exact->particles;
    auto samples = draw_samples(tree, symbols, {FamilyKind::random, 0}, options);
    if (samples) {
      put_sample(tree, *exact, *samples);
      trials.samples.emplace_back("exact", std::move(*samples));
    }
  }
  const auto draw = [&](const InputFamily& family, const Body* body, const BodyLetters& letters) {
    if (!applies(family, tree, symbols, body)) return;
    auto drawn = draw_samples(tree, symbols, family,
                              {.samples = sample_count, .seed = 7, .body = body, .letters = letters});
    if (!drawn || !meets_assumptions(tree, question, *drawn, assumed_uncertainty)) return;
    trials.samples.emplace_back(body != nullptr ? body->name : name_of(family), std::move(*drawn));
  };
  for (const InputFamily& family : input_families()) draw(family, nullptr, {});
  const auto letters = body_letters(tree, pointers);
  const bool of_bodies = letters && (letters->mass || letters->position);
  for (const Body& body : bodies) {
    if (!of_bodies) break;
    for (const FamilyKind kind : {FamilyKind::random, FamilyKind::thin_axis})
      draw({kind, 0}, &body, *letters);
  }
  return trials;
}

}  // namespace rigor::agreement
