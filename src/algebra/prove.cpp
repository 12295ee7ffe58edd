// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/prove.h"

#include <fmt/format.h>

#include "algebra/components.h"
#include "algebra/constraints.h"
#include "base/check.h"

namespace rigor {
namespace {

[[nodiscard]] Proof prove_components(const Scope& scope, const Attempt& attempt, const Limits& limits,
                                     Work& work) {
  const Equation& claim = scope.question().claim;
  GenericDomain domain(scope, limits, attempt.effort, work);
  Evaluator<GenericDomain> evaluator(scope, domain);
  Constraints constraints(scope, domain, evaluator);
  constraints.assume(attempt.assumptions);
  for (std::size_t i = 0; i < claim.particles.size(); ++i) {
    evaluator.bind(claim.particles[i], first_free_frame + static_cast<Frame>(i));
  }
  const auto is_zero = [&](const Fraction& left, const Fraction& right) {
    for (const Fraction* side : {&left, &right}) {
      for (const Divisor& divisor : side->divisors) {
        if (constraints.reduced(divisor.base).is_zero())
          throw Undecidable("a denominator is zero under the assumptions");
        constraints.note_nonzero(divisor.base);
      }
    }
    return constraints.vanishes(domain.difference(left, right));
  };
  Proof proof;
  proof.holds = for_each_component(
      evaluator, scope.tree(), claim,
      [&](const auto&, const Fraction& left, const Fraction& right) { return is_zero(left, right); });
  proof.vanishes = proof.holds && for_each_component(evaluator, scope.tree(), claim,
                                                     [&](const auto&, const Fraction& left, const Fraction&) {
                                                       return is_zero(left, Fraction{});
                                                     });
  proof.moments = domain.used_moments();
  proof.unit_vectors = domain.used_unit_vectors();
  proof.rotations = domain.used_rotations();
  proof.radicals = domain.used_radicals();
  proof.unsolved_assumptions = !proof.holds && constraints.incomplete();
  return proof;
}

}  // namespace

Proof prove(const Scope& scope, const Attempt& attempt, const Limits& limits, Work& work) {
  try {
    return prove_components(scope, attempt, limits, work);
  } catch (const Undecidable&) {
    throw;
  } catch (const InternalError&) {
    throw;
  } catch (const std::exception& error) {
    throw Undecidable(fmt::format("the computer algebra library gave up: {}", error.what()));
  }
}

}  // namespace rigor
