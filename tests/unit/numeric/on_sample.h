// SPDX-License-Identifier: GPL-3.0-or-later
// Programs beside the exact evaluator: a claim that is false for any value of a term is refuted on a sample,
// and the term's exact value there is what its program must give.
#pragma once

#include <string>
#include <vector>

#include "algebra/decide/decide.h"
#include "base/check.h"
#include "expr/build.h"
#include "numeric/measure/evaluate.h"
#include "numeric/program/run_plan.h"

namespace rigor::build {

[[nodiscard]] inline double to_double(const std::string& rational) {
  const std::size_t slash = rational.find('/');
  const double numerator = std::stod(rational);
  return slash == std::string::npos ? numerator : numerator / std::stod(rational.substr(slash + 1));
}

[[nodiscard]] inline Program compiled(const Page& page, const Term& term,
                                      const std::vector<IndexId>& indices = {}) {
  const ProgramRoot root{term.id, indices};
  auto program = Program::compile(page.tree, page.question.definitions, std::span(&root, 1));
  RIGOR_CHECK(program.has_value(), program ? std::string() : program.error().reason);
  return *program;
}

[[nodiscard]] inline Samples samples_of(const Page& page, const Sample& sample) {
  Samples samples(1, sample.particles);
  for (const SampleValue& value : sample.values) {
    for (std::size_t i = 0; i < value.components.size(); ++i) {
      const auto component = static_cast<std::uint32_t>(i);
      if (!page.tree.symbols[value.symbol].per_particle) {
        samples.set(value.symbol, component, to_double(value.components[i]));
        continue;
      }
      const Column* before = samples.find(value.symbol, component);
      std::vector<double> column(sample.particles);
      if (before != nullptr) column.assign(before->values.begin(), before->values.end());
      column[value.particle - 1] = to_double(value.components[i]);
      samples.set_particles(value.symbol, component, column);
    }
  }
  return samples;
}

struct Compared {
  double exact = 0.0;
  double computed = 0.0;
};

/// The component at which the exact side finds that a term is not its own opposite (or successor).
[[nodiscard]] inline Compared compare(Page& page, const Term& term, const std::vector<IndexId>& indices = {},
                                      const std::vector<ParticleId>& particles = {}) {
  const Term other = term.rank() == 0 ? term + page.number("1") : -term;
  Limits limits;
  limits.simplest_sample = false;
  const Decision decision = decide(page.claim(term, other, indices, particles), limits);
  RIGOR_CHECK(decision.sample.has_value(), decision.reason);
  std::size_t at = 0;
  for (const std::uint8_t axis : decision.sample->axes) at = 3 * at + (axis - 1u);
  std::vector<std::uint32_t> free;
  const Program program = compiled(page, term, indices);
  for (const ParticleId id : program.free_particles()) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (particles[i] == id) free.push_back(decision.sample->free_particles[i] - 1);
    }
  }
  const Samples samples = samples_of(page, *decision.sample);
  return {to_double(decision.sample->left), evaluate(program, samples, Arithmetic::plain, free)[at]};
}

}  // namespace rigor::build
