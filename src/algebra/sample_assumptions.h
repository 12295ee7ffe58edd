// SPDX-License-Identifier: GPL-3.0-or-later
// Makes an exact sample meet assumptions, by solving for some of its numbers.
#pragma once

#include <vector>

#include "algebra/sample_evaluator.h"

namespace rigor {

/// The assumptions that samples have to meet, and the search for the numbers to change. Method: for each
/// component of each assumption that does not hold yet, a number in which left − right is linear is solved
/// for, and not touched again: first one of a symbol that no earlier assumption has, then of one that is a
/// whole side, then one of the last particle, then of higher rank. Sides that an order holds apart are put at
/// a small distance first. In the end everything is verified. Not complete: where the search finds nothing,
/// another sample or another order (`attempt`) may do.
class AssumptionSolver {
 public:
  AssumptionSolver(const Scope& scope, std::vector<std::size_t> assumptions);

  [[nodiscard]] bool none() const { return assumptions_.empty(); }
  [[nodiscard]] const std::vector<std::size_t>& assumptions() const { return assumptions_; }
  /// True if all assumptions hold on the point as it is. May throw PointRejected.
  [[nodiscard]] bool holds(SampleEvaluator& evaluator, const SamplePoint& point) const;
  /// Changes the point so that all hold; false, or PointRejected, if that was not found.
  [[nodiscard]] bool solve(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t attempt) const;

 private:
  void solve_equations(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t attempt) const;
  void solve_orders(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t turn) const;
  [[nodiscard]] std::vector<Coordinate> candidates(const SamplePoint& point, std::size_t assumption,
                                                   std::uint32_t attempt) const;

  const Scope* scope_;
  std::vector<std::size_t> assumptions_;
  std::vector<std::vector<SymbolId>> symbols_;  // of each
  bool has_orders_ = false;
};

}  // namespace rigor
