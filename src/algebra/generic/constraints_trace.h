// SPDX-License-Identifier: GPL-3.0-or-later
// How assumptions were solved and used, for whoever writes the proof down. Expressions of GiNaC are shared,
// so that an account of them costs next to nothing while nobody knows whether there will be a proof.
#pragma once

#include <ginac/ex.h>

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "algebra/point/indeterminates.h"

namespace rigor {

struct ConstraintsTrace {
  /// An equation that is given: f = 0.
  struct Given {
    enum class Origin : std::uint8_t { assumption, unit_vector, square_of_previous };
    GiNaC::ex equation;
    Origin origin = Origin::assumption;
    std::size_t assumption = 0;
    std::vector<std::uint8_t> axes = {};
    std::vector<Frame> particles = {};
  };
  /// A given equation, with all others put into it, was solved for an indeterminate.
  struct Elimination {
    GiNaC::ex indeterminate;
    std::size_t given = 0;
  };
  /// What is left of a given equation.
  struct Left {
    std::size_t given = 0;
    GiNaC::ex monic_in;
  };
  struct Determinant {
    std::array<std::size_t, 3> rows{};  // given equations
    std::size_t unit_vector = 0;        // the given equation n·n = 1
    std::array<GiNaC::ex, 3> vector;    // n
  };
  struct Nonzero {
    Numerator value;
    std::optional<std::size_t> assumption = {};  // that says so; none: it is in a denominator
  };
  /// An assumption about each particle that was solved for a number of its own.
  struct OfEachParticle {
    std::size_t assumption = 0;
    GiNaC::ex indeterminate;
    GiNaC::ex worth;
  };
  /// A polynomial was found to vanish.
  struct Vanishing {
    enum class How : std::uint8_t { eliminated, determinant, combination, divided, cases };
    Numerator value;
    How how = How::eliminated;
    std::size_t determinant = 0;              // determinant: which
    Numerator core = {};                      // combination: without factors that are not 0
    std::optional<std::size_t> nonzero = {};  // combination: times this one, reduced
    int power = 0;                            // so often
    std::vector<std::size_t> left = {};       // combination: among those that are left
    std::set<std::size_t> from = {};          // assumptions
  };
  std::vector<Given> given;
  std::vector<Elimination> eliminations;
  std::vector<Left> left;
  std::vector<Determinant> determinants;
  std::vector<Nonzero> nonzero;
  std::vector<OfEachParticle> of_each_particle;
  std::vector<Vanishing> vanishings;
};

}  // namespace rigor
