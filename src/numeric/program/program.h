// SPDX-License-Identifier: GPL-3.0-or-later
// A straight-line program for expressions of a tree as they are written: components are spelled out, common
// subexpressions of one program are computed once, and what does not depend on a particle is computed outside
// the loop over particles. Nothing is expanded, factored or reordered: a product of three factors is
// multiplied from left to right, a sum is added from left to right, ε and δ only leave out terms that are 0.
// Sums over particles are streamed. Compiling takes microseconds; no compiler runs.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/result.h"
#include "expr/statement/statement.h"

namespace rigor {

/// An expression to evaluate. Its results are the components for all values of the free indices (the first
/// one is the most significant), then of its axes, row by row: 3^(indices + rank).
struct ProgramRoot {
  ExprId expr{};
  std::span<const IndexId> indices = {};
};

/// One component of a free symbol. `particle`: no_particle where it belongs to no particle or is summed over;
/// a free particle variable of a root is fixed when the program runs.
struct ProgramInput {
  SymbolId symbol{};
  std::uint32_t component = 0;  // canonical: `canonical_component` of a symmetric tensor
  bool per_particle = false;
};

/// How the work is counted: arithmetic once a sample, and once a sample and particle.
struct ProgramCounts {
  std::size_t once = 0;
  std::size_t per_particle = 0;  // in loops over particles, of any depth
};

struct Code;  // numeric/program/code.h

class Program {
 public:
  /// Definitions are unfolded wherever their symbols stand; the last one of a symbol counts. An even power of
  /// what is defined by its square takes no root. Fails where definitions go in a circle, or the program
  /// would be too large.
  [[nodiscard]] static Result<Program> compile(const ExprTree& tree, std::span<const Definition> definitions,
                                               std::span<const ProgramRoot> roots);

  /// Those that a result depends on, each component once.
  [[nodiscard]] std::span<const ProgramInput> inputs() const;
  [[nodiscard]] std::size_t outputs() const;
  [[nodiscard]] bool sums_over_particles() const;
  /// The roots' free particle variables, in order of first occurrence: values for them are given to `run`.
  [[nodiscard]] std::span<const ParticleId> free_particles() const;
  [[nodiscard]] ProgramCounts counts() const;
  [[nodiscard]] const Code& code() const { return *code_; }

 private:
  std::shared_ptr<const Code> code_;
};

}  // namespace rigor
