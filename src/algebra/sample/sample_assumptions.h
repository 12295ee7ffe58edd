// SPDX-License-Identifier: GPL-3.0-or-later
// Makes an exact sample meet assumptions, by solving for some of its numbers.
#pragma once

#include <span>
#include <vector>

#include "algebra/sample/sample_evaluator.h"

namespace rigor {

/// The assumptions that samples have to meet, and the search for the numbers to change. Method: differential
/// equations of one order are solved together for the derivatives of that order, in which they are linear as
/// a rule, lower orders before higher ones. Each other assumption that does not hold yet is solved for the
/// numbers of one symbol, if it is linear in them: one that no other assumption has, then one that no earlier
/// one has, then one that is a whole side, then a particle's. A number that several orders bound is put
/// between them; tensors for which that does not do are tried as well-known matrices. What an assumption was
/// solved for is not touched by others; where it is broken by them, it is solved again, a few times. Sides
/// that an order holds apart are put at a small distance first. In the end everything is verified. Not
/// complete: where the search finds nothing, another sample or another order (`attempt`) may do.
class AssumptionSolver {
 public:
  AssumptionSolver(const Scope& scope, std::vector<std::size_t> assumptions);

  [[nodiscard]] bool none() const { return assumptions_.empty(); }
  [[nodiscard]] const std::vector<std::size_t>& assumptions() const { return assumptions_; }
  /// Is one about a sum over particles?
  [[nodiscard]] bool has_particle_sums() const { return has_particle_sums_; }
  /// True if all assumptions hold on the point as it is. May throw PointRejected.
  [[nodiscard]] bool holds(SampleEvaluator& evaluator, const SamplePoint& point) const;
  /// Changes the point so that all hold; false, or PointRejected, if that was not found.
  [[nodiscard]] bool solve(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t attempt) const;

 private:
  struct Owned {  // a number that an assumption was solved for
    Coordinate at;
    std::size_t assumption;
  };
  struct Search {
    SampleEvaluator& evaluator;
    SamplePoint& point;
    std::uint32_t attempt;
    std::vector<Owned> owned = {};
  };
  [[nodiscard]] bool solve_equations(SampleEvaluator& evaluator, SamplePoint& point,
                                     std::uint32_t attempt) const;
  [[nodiscard]] bool solve_equation(Search& search, std::size_t assumption) const;
  [[nodiscard]] std::vector<Rational> residuals_at(const Search& search, const SamplePoint& point,
                                                   std::size_t assumption) const;
  [[nodiscard]] bool solve_together(Search& search, std::span<const std::size_t> assumptions,
                                    std::span<const SymbolId> symbols,
                                    const std::vector<std::vector<Rational>>& residuals) const;
  [[nodiscard]] std::vector<Coordinate> unknowns_of(const Search& search,
                                                    std::span<const std::size_t> assumptions,
                                                    std::span<const SymbolId> symbols) const;
  void solve_derivatives(Search& search, int order) const;
  [[nodiscard]] bool solve_place_by_place(Search& search, std::size_t assumption) const;
  [[nodiscard]] const Equation& equation(std::size_t assumption) const {
    return scope_->question().assumptions[assumptions_[assumption]];
  }
  [[nodiscard]] bool is_side(std::size_t assumption, SymbolId symbol) const;
  void order_symbols(std::size_t assumption);
  void solve_orders(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t turn, bool between) const;
  struct Interval;
  [[nodiscard]] Interval interval_of(SampleEvaluator& evaluator, SamplePoint& point,
                                     const Coordinate& at) const;
  [[nodiscard]] bool put_between(SampleEvaluator& evaluator, SamplePoint& point, const Coordinate& at,
                                 std::uint32_t turn) const;
  [[nodiscard]] bool is_free_tensor(SymbolId symbol) const;
  void put_known_tensors(SamplePoint& point, std::uint32_t attempt) const;
  [[nodiscard]] bool solve_as_drawn(SampleEvaluator& evaluator, SamplePoint& point,
                                    std::uint32_t attempt) const;
  [[nodiscard]] std::vector<Coordinate> candidates(const SamplePoint& point, std::size_t assumption,
                                                   std::uint32_t attempt) const;

  const Scope* scope_;
  std::vector<std::size_t> assumptions_;
  std::vector<std::vector<SymbolId>> symbols_;  // of each, the first are the first to be solved for
  std::vector<int> derivative_orders_;          // of each, as a differential equation; 0: it is none
  bool has_orders_ = false;
  bool has_tensors_ = false;  // an equation is about a tensor that is no rotation
  bool has_particle_sums_ = false;
};

}  // namespace rigor
