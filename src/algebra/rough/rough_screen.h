// SPDX-License-Identifier: GPL-3.0-or-later
// A look before a proof is searched for: does the claim fail where its assumptions hold? Nearly every set of
// laws that is tried proves nothing, and to find that out by algebra takes a hundred times as long.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "algebra/engine/budget.h"
#include "algebra/point/scope.h"
#include "expr/statement/statement.h"

namespace rigor {

/// True only where the sides of an equation clearly differ at several points at which all assumptions hold,
/// or those of an order are clearly the other way round at one, so that a proof would be a surprise. It
/// refutes nothing. Points are real numbers of double precision, drawn from a fixed sequence and moved onto
/// the assumptions by Newton's method with the smallest steps; thresholds are orders of magnitude apart, so
/// that rounding hardly decides. False where that does not work: of operators, rotations and ≠, of more than
/// 128 numbers, and where no point is found. The budget may be none.
[[nodiscard]] bool fails_at_rough_points(const Question& question, Budget* budget);

/// Is there such a point, at which the claim has a value as well? Its assumptions contradict each other then
/// no more than rounding can hide.
[[nodiscard]] bool is_met_at_rough_points(const Question& question, Budget* budget);

/// The same for a question about real numbers and several choices of its assumptions: its program is written
/// once.
class RoughScreen {
 public:
  /// The scope outlives this; the assumptions are all those of which some are taken.
  RoughScreen(const Scope& scope, std::vector<std::size_t> assumptions, Budget* budget);
  ~RoughScreen();
  RoughScreen(const RoughScreen&) = delete;
  RoughScreen& operator=(const RoughScreen&) = delete;

  [[nodiscard]] bool fails_under(std::span<const std::size_t> assumptions);
  /// Is there such a point at which all of the claim has a value?
  [[nodiscard]] bool has_values_under(std::span<const std::size_t> assumptions);

 private:
  class Points;
  std::unique_ptr<Points> points_;  // none: it has no rough points
};

}  // namespace rigor
