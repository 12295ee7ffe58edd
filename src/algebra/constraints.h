// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions at the generic point. Each component gives an equation between indeterminates (moments
// included), and every equation is solved *before* a claim is tested; nothing is a rewrite rule. Method, in
// this order:
//  1. an assumption for each particle is solved for one of the particle's own numbers (numeric coefficient),
//  in any particle's name;
//  2. Gaussian elimination: an equation that is linear in an indeterminate with a numeric coefficient is
//  solved for it;
//  3. what is left: one that is monic in an indeterminate reduces its powers (n·n = 1); others must divide
//  the residue.
// An equation with a single root in it is used squared, too. Everything used is a consequence of the
// assumptions: sound. Steps 1 and 2 lose nothing (the solutions of such an equation are the graph of a
// polynomial); step 3 is complete for one irreducible equation (a·x + b with coprime a and b, say, as in A·B
// = 0), not for several. A moment is replaced where it stands as a factor: Σ m r = 0 makes M[m r_i] zero, not
// M[m r_i v_j].
#pragma once

#include <span>
#include <vector>

#include "algebra/generic_evaluator.h"

namespace rigor {

class Constraints {
 public:
  Constraints(const Scope& scope, GenericDomain& domain, Evaluator<GenericDomain>& evaluator)
      : scope_(scope), domain_(domain), evaluator_(evaluator) {}

  /// Solves the assumptions at these positions. The claim's free particles are frames from first_free_frame
  /// on. Throws Undecidable if they contradict each other.
  void assume(std::span<const std::size_t> positions);

  /// A polynomial on the solutions: zero if it is proved to vanish there.
  [[nodiscard]] GiNaC::ex reduced(const GiNaC::ex& value);

  /// Are there equations that could not be solved for an indeterminate?
  [[nodiscard]] bool incomplete() const { return !remaining_.empty(); }

 private:
  struct Solution {
    GiNaC::ex indeterminate;
    GiNaC::ex worth;
  };
  struct Remaining {
    GiNaC::ex equation;  // expanded, not constant
    GiNaC::ex monic_in;  // 0: in none
  };

  void solve_for_each_particle(const Equation& assumption);
  void collect(const Equation& assumption);
  void eliminate();
  [[nodiscard]] bool replace_own_number(const GiNaC::ex& equation);
  [[nodiscard]] GiNaC::ex substituted(const GiNaC::ex& value, const Solution& by);
  [[nodiscard]] GiNaC::ex linear_indeterminate(const GiNaC::ex& equation) const;
  [[nodiscard]] GiNaC::ex monic_indeterminate(const GiNaC::ex& equation) const;

  const Scope& scope_;
  GenericDomain& domain_;
  Evaluator<GenericDomain>& evaluator_;
  std::vector<GiNaC::ex> equations_;
  std::vector<Solution> solutions_;
  std::vector<Remaining> remaining_;
};

}  // namespace rigor
