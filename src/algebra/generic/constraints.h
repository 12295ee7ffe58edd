// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions at the generic point. Each component gives an equation between indeterminates (moments
// included), and every equation is solved *before* a claim is tested; nothing is a rewrite rule. Method, in
// this order:
//  1. an assumption for each particle is solved for one of the particle's own numbers (numeric coefficient),
//  in any particle's name;
//  2. Gaussian elimination: an equation that is linear in an indeterminate with a numeric coefficient is
//  solved for it;
//  3. what is left: one that is monic in an indeterminate reduces its powers (n·n = 1);
//  4. the residue is a combination of the equations with cofactors of low degree (`membership.h`), or
//  vanishes in each of several cases (`cases.h`).
// Where three equations say M n = 0 for a unit vector n, det M = 0 (`kernel.h`).
// An equation with a single root in it is used squared, too. What is in a denominator is not 0. A unit
// vector that assumptions are about is three coordinates with n·n = 1: the stereographic chart misses a point
// that they may single out. Everything used is a consequence of the assumptions: sound. Steps 1 and 2 lose
// nothing (the solutions of such an equation are the graph of a polynomial); the others are bounded.
// Assumptions with <, ≤ and ≠ are no equations: they say signs (`signs.h`). A moment is replaced where it
// stands as a factor: Σ m r = 0 makes M[m r_i] zero, not M[m r_i v_j].
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "algebra/generic/cases.h"
#include "algebra/generic/constraints_trace.h"

namespace rigor {

class Constraints {
 public:
  Constraints(const Scope& scope, GenericDomain& domain, Evaluator<GenericDomain>& evaluator)
      : scope_(scope), domain_(domain), evaluator_(evaluator) {}

  /// Solves the assumptions at these positions. The claim's free particles are frames from first_free_frame
  /// on. Throws Undecidable if they contradict each other.
  void assume(std::span<const std::size_t> positions);

  /// Unit vectors that are free become three coordinates with n·n = 1. To be called before `assume`.
  void take_unit_vectors_as_coordinates(std::span<const SymbolId> symbols);

  /// The known signs, on the solutions. Throws Contradiction if they cannot hold.
  [[nodiscard]] std::vector<Signs::Fact> reduced_facts();

  /// A denominator, or a polynomial that is not 0 for another reason.
  void note_nonzero(const Numerator& value, std::optional<std::size_t> assumption = {});

  /// A polynomial on the solutions, after steps 2 and 3.
  [[nodiscard]] Numerator reduced(const Numerator& value);
  /// Is a polynomial proved to be zero on the solutions? Throws Undecidable where there are none.
  [[nodiscard]] bool vanishes(const Numerator& value);

  /// Are there equations that could not be solved for an indeterminate?
  [[nodiscard]] bool incomplete() const { return !remaining_.empty(); }

  /// The positions of the assumptions that were used so far, with `signs` also those that say signs. They are
  /// likely to be enough.
  [[nodiscard]] std::set<std::size_t> used(bool signs) const;

  [[nodiscard]] const ConstraintsTrace& trace() const { return trace_; }

 private:
  using Positions = std::set<std::size_t>;  // of assumptions
  struct Known {
    Numerator equation;
    Positions from;
    std::size_t given = 0;  // position in the trace
  };
  struct Solution {
    GiNaC::ex indeterminate;
    std::size_t letter = 0;  // its position
    Numerator worth;
    Positions from;
  };
  struct UnitVector {
    SymbolId symbol{};
    std::size_t given = 0;  // n·n = 1, by its position in the trace
  };
  struct Remaining {
    Numerator equation;  // expanded, not constant
    GiNaC::ex monic_in;  // 0: in none
    Positions from;
    std::set<std::size_t> indeterminates;  // by position
  };

  void learn_signs(std::size_t position);
  void solve_for_each_particle(std::size_t position);
  void collect(std::size_t position);
  void collect_determinants(std::span<const GiNaC::ex> equations, std::size_t first, std::size_t position);
  void give(ConstraintsTrace::Given given, Positions from);
  void eliminate();
  [[nodiscard]] bool replace_own_number(const GiNaC::ex& equation, std::size_t position);
  [[nodiscard]] Numerator solved(const Numerator& value);
  [[nodiscard]] bool is_determinant(const Numerator& value, ConstraintsTrace::Vanishing& found);
  [[nodiscard]] bool vanishes(const Numerator& value, ConstraintsTrace::Vanishing& found);
  void use(const Positions& positions);
  [[nodiscard]] std::vector<std::size_t> remaining_about(const Numerator& value) const;
  [[nodiscard]] bool is_combination_times_nonzero(const Numerator& value, const System& system,
                                                  ConstraintsTrace::Vanishing& found);
  [[nodiscard]] int degree_in(const Numerator& value, const Solution& by) const;
  [[nodiscard]] Numerator substituted(const Numerator& value, const Solution& by);
  void substitute(Numerator& value, Positions& from, const Solution& by);
  [[nodiscard]] const PackedLetters& letters() const { return domain_.indeterminates().letters(); }
  [[nodiscard]] std::vector<int> degrees(const Numerator& equation) const;
  [[nodiscard]] std::optional<std::size_t> linear_indeterminate(const Numerator& equation) const;
  [[nodiscard]] GiNaC::ex monic_indeterminate(const Numerator& equation) const;

  const Scope& scope_;
  GenericDomain& domain_;
  Evaluator<GenericDomain>& evaluator_;
  std::vector<Known> equations_;
  std::vector<Known> determinants_;       // of what makes a unit vector vanish
  std::vector<UnitVector> unit_vectors_;  // that are three coordinates
  Positions orders_;                      // <, ≤ and ≠
  Positions used_;
  std::vector<Solution> solutions_;
  std::vector<Remaining> remaining_;
  ConstraintsTrace trace_;
};

}  // namespace rigor
