// SPDX-License-Identifier: GPL-3.0-or-later
// The search for an exact sample on which a claim fails, and for the simplest such sample.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "algebra/engine/limits.h"
#include "algebra/sample/sample_assumptions.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Method: points are drawn from a fixed sequence, solved for the assumptions, and the sides are compared
/// there as exact numbers; where none of them gives both sides one, as numbers that are enclosed between
/// others. A difference is a refutation; no difference at any number of points is not a proof, but for a
/// claim without symbols.
class Refuter {
 public:
  /// The scope's definitions are unfolded. Only assumptions that bear on the claim are met.
  Refuter(const Scope& scope, const Limits& limits);
  Refuter(const Refuter&) = delete;
  Refuter& operator=(const Refuter&) = delete;

  struct Counterexample {
    SamplePoint drawn;  // before the assumptions were solved for
    SamplePoint point;  // on which the claim fails
    std::uint32_t attempt = 0;
    Difference difference;
  };

  /// A few generic points: fast, and nearly every false claim fails there.
  [[nodiscard]] std::optional<Counterexample> quick_look();
  /// Does the claim fail where no assumption is met, either? Then it has no proof without them.
  [[nodiscard]] bool fails_without_assumptions();
  /// All attempts that the limits allow, with up to 6 particles; for an order, first where symbols are 0.
  [[nodiscard]] std::optional<Counterexample> search();
  /// Do both sides have a value anywhere?
  [[nodiscard]] bool finds_a_point();
  /// The simplest counterexample found from a given one: tiny points first, then one number after the other
  /// made smaller.
  [[nodiscard]] Sample simplest(const Counterexample& found);
  /// As it is.
  [[nodiscard]] Sample to_sample(const Counterexample& found) const;

  [[nodiscard]] const Reach& reach() const { return reach_; }
  [[nodiscard]] const std::vector<std::size_t>& assumptions() const { return solver_.assumptions(); }
  /// How many points met the assumptions and gave both sides a rational value.
  [[nodiscard]] std::uint32_t points_compared() const { return points_compared_; }
  [[nodiscard]] std::uint32_t points_tried() const { return sequence_.drawn() + looked_at_zero_; }
  /// Is the left side zero by itself, on the last point that was compared?
  [[nodiscard]] bool left_vanishes() { return evaluator_.left_vanishes(scope_->question().claim); }
  /// Without symbols and particles, each side is one number: a comparison at one point is a proof.
  [[nodiscard]] bool is_constant() const { return reach_.symbols.empty() && !reach_.particles; }

 private:
  [[nodiscard]] std::optional<Counterexample> attempt_next();
  [[nodiscard]] std::optional<Counterexample> look_at_zero();
  [[nodiscard]] std::optional<Counterexample> search_enclosed();
  /// With a bound, only simpler points are compared.
  [[nodiscard]] std::optional<Counterexample> fails_on(const SamplePoint& drawn, std::uint32_t attempt,
                                                       const Complexity* below = nullptr);
  void consider(Counterexample& best, const SamplePoint& drawn, std::uint32_t attempt);
  void look_among_few(Counterexample& best);
  void look_among_few(Counterexample& best, std::uint32_t particles, int scalar, std::span<const int> values);
  void look_among_tiny_points(Counterexample& best);
  void clear_symbols(Counterexample& best);
  void exchange_axes(Counterexample& best);
  void descend(Counterexample& best);
  void shrink(Counterexample& best, std::uint64_t one_look);
  void drop_particles(Counterexample& best);
  void take_multiples_away(Counterexample& best);
  void make_particles_alike(Counterexample& best);
  void make_scalars_alike(Counterexample& best);
  [[nodiscard]] bool make_smaller(Counterexample& best);
  [[nodiscard]] bool may_shrink() const;

  static constexpr std::uint32_t most_looks = 150;        // of an enumeration, where nothing is assumed
  static constexpr std::uint32_t most_solved_looks = 80;  // where assumptions are solved for each time

  const Scope* scope_;
  Limits limits_;
  AssumptionSolver solver_;
  Reach reach_;  // of the claim, then of the assumptions
  SampleEvaluator evaluator_;
  std::optional<SamplePoint> point_;  // the one that is being looked at
  SampleSequence sequence_;
  std::uint32_t points_compared_ = 0;  // different ones
  bool has_near_values_ = false;       // at a point where the sides could not be told apart
  std::set<std::string> compared_;
  std::uint32_t looked_at_zero_ = 0;     // points
  std::uint64_t shrinks_until_ = 0;      // steps
  std::vector<SymbolId> claim_symbols_;  // free symbols that the claim reaches, in its order
  std::uint32_t looks_left_ = 0;         // of an enumeration
};

/// The unit vectors along the axes, or the rotations that a reader knows, the simplest first.
[[nodiscard]] std::vector<std::vector<Rational>> simple_wholes(const Symbol& symbol);

/// The claim and the assumptions that bear on it: what a sample has to give values for.
[[nodiscard]] Reach reach_of_sample(const Scope& scope, const std::vector<std::size_t>& assumptions);

}  // namespace rigor
