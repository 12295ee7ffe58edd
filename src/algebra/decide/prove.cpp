// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/decide/prove.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "algebra/evaluator/components.h"
#include "algebra/generic/constraints.h"
#include "algebra/generic/order.h"
#include "algebra/generic/written_proof.h"
#include "base/check.h"

namespace rigor {
namespace {

/// Does right − left have a sign that the relation allows?
[[nodiscard]] bool has_order(GenericDomain& domain, Constraints& constraints, Relation relation,
                             const Fraction& difference) {
  const Sign allowed = relation == Relation::less            ? Sign::positive
                       : relation == Relation::less_or_equal ? Sign::not_negative
                                                             : Sign::not_zero;
  if (is_surely(domain.signs().of(difference), allowed)) return true;
  const GiNaC::ex value = constraints.reduced(domain.with_sign_of(difference));
  return Order(domain).is_within(value, allowed, constraints.reduced_facts());
}

/// What the normal form took, the steps, and the assumptions that no step names.
void write_down(Proof& proof, const Scope& scope, GenericDomain& domain, const Constraints& constraints,
                std::span<const std::vector<std::uint8_t>> axes, const Attempt& attempt) {
  const bool order = scope.question().claim.relation != Relation::equal;
  proof.method = order ? Proof::Method::sign : Proof::Method::normal_form;
  proof.moments = domain.used_moments();
  proof.unit_vectors = domain.used_unit_vectors();
  proof.rotations = domain.used_rotations();
  proof.radicals = domain.used_radicals();
  proof.functions = domain.used_functions();
  write_steps(proof, scope, domain, constraints.trace(), axes);
  if (order) {
    const auto used = constraints.used(true);
    proof.steps.push_back({.kind = ProofStep::Kind::sign, .assumptions = {used.begin(), used.end()}});
  }
  const std::vector<std::size_t> named = assumptions_of(proof);
  for (const std::size_t position : attempt.assumptions) {
    if (!std::ranges::binary_search(named, position)) proof.in_force.push_back(position);
  }
}

[[nodiscard]] Trial prove_components(const Scope& scope, const Attempt& attempt, const Limits& limits,
                                     Work& work, int angle_divisor) {
  const Equation& claim = scope.question().claim;
  GenericDomain domain(scope, limits, attempt.effort, work, angle_divisor);
  Evaluator<GenericDomain> evaluator(scope, domain);
  Constraints constraints(scope, domain, evaluator);
  for (const KnownSign& each : attempt.signs) {
    const GiNaC::ex letter = domain.indeterminates().coordinate(each.letter, 0, common_frame);
    domain.signs().add_fact(letter, each.positive ? Sign::positive : Sign::negative);
  }
  // An equation or ≤ that holds on all of the chart holds at the point that it misses; < and ≠ need not.
  if (claim.relation == Relation::less || claim.relation == Relation::unequal) {
    constraints.take_unit_vectors_as_coordinates(reach(scope, claim).symbols);
  }
  constraints.assume(attempt.assumptions);
  for (std::size_t i = 0; i < claim.particles.size(); ++i) {
    evaluator.bind(claim.particles[i], first_free_frame + static_cast<Frame>(i));
  }
  const auto note_divisors = [&](const Fraction& left, const Fraction& right) {
    for (const Fraction* side : {&left, &right}) {
      for (const Divisor& divisor : side->divisors) {
        if (constraints.reduced(divisor.base).is_zero())
          throw Undecidable("a denominator is zero under the assumptions");
        constraints.note_nonzero(divisor.base);
        if (claim.relation != Relation::equal) domain.signs().add_fact(divisor.base, Sign::not_zero);
      }
    }
  };
  std::vector<std::vector<std::uint8_t>> reduced;  // the components that were not zero as they stood
  const auto is_zero = [&](const auto& axes, const Fraction& left, const Fraction& right) {
    note_divisors(left, right);
    const std::size_t before = constraints.trace().vanishings.size();
    const bool zero = constraints.vanishes(domain.difference(left, right));
    if (constraints.trace().vanishings.size() > before) reduced.push_back(axes);
    return zero;
  };
  const auto is_right = [&](const auto& axes, const Fraction& left, const Fraction& right) {
    if (claim.relation == Relation::equal) return is_zero(axes, left, right);
    note_divisors(left, right);
    domain.signs().conclude();
    return has_order(domain, constraints, claim.relation, domain.subtracted(right, left));
  };
  if (claim.relation != Relation::equal) domain.note_signs_as_written();
  const auto vanishes_alone = [&](const Fraction& left, const Fraction& right) {  // both are equal
    return right.numerator.is_zero() || constraints.reduced(domain.difference(left, Fraction{})).is_zero();
  };
  bool vanishes = claim.relation == Relation::equal;
  Trial trial;
  const auto holds = [&] {
    return for_each_component(evaluator, scope.tree(), claim,
                              [&](const auto& axes, const Fraction& left, const Fraction& right) {
                                if (!is_right(axes, left, right)) return false;
                                vanishes = vanishes && vanishes_alone(left, right);
                                return true;
                              });
  };
  const std::size_t facts = domain.signs().facts().size();
  trial.holds = holds();
  // What has a root is not negative, which may split a root that was taken earlier: √(ab) = √a √b.
  const bool learnt = domain.signs().facts().size() > facts && attempt.effort == Effort::plain;
  if (!trial.holds && claim.relation == Relation::equal && learnt && reduced.empty()) {
    evaluator.forget();
    vanishes = true;
    trial.holds = holds();
  }
  trial.radicals = domain.used_radicals();
  trial.unsolved_assumptions = !trial.holds && constraints.incomplete();
  if (!trial.holds) return trial;
  const bool by_signs =
      claim.relation != Relation::equal || domain.used_radicals() || domain.used_functions();
  const auto used = constraints.used(by_signs);
  trial.used.assign(used.begin(), used.end());
  trial.proof.vanishes = vanishes;
  write_down(trial.proof, scope, domain, constraints, reduced, attempt);
  return trial;
}

}  // namespace

Trial prove(const Scope& scope, const Attempt& attempt, const Limits& limits, Work& work) {
  try {
    for (int angle_divisor = 1;;) {
      try {
        return prove_components(scope, attempt, limits, work, angle_divisor);
      } catch (const FinerAngles& finer) {
        angle_divisor = finer.divisor();
      }
    }
  } catch (const Undecidable&) {
    throw;
  } catch (const InternalError&) {
    throw;
  } catch (const std::exception& error) {
    throw Undecidable(fmt::format("the computer algebra library gave up: {}", error.what()));
  }
}

}  // namespace rigor
