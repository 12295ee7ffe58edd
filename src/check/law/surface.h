// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of states with two letters as coordinates: see `states.h`.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "expr/calculus/differentiate.h"
#include "expr/statement/statement.h"

namespace rigor {

/// One letter varies, the other one is held; and the other way round.
struct Coordinates {
  SymbolId u{};
  SymbolId v{};
  friend auto operator<=>(const Coordinates&, const Coordinates&) = default;
};

/// Derivatives along the coordinates, as symbols `(\partial X/\partial u)_v`.
class Surface {
 public:
  /// `states`: the letters that change with u and v; all others are constant.
  Surface(ExprTree& tree, Coordinates coordinates, std::set<SymbolId> states);
  Surface(const Surface&) = delete;  // the differentiators refer to it
  Surface& operator=(const Surface&) = delete;

  /// By u (0) or v (1).
  [[nodiscard]] ExprId along(ExprId of, int which) { return by_[which].derivative_or_zero(of); }
  [[nodiscard]] Equation along(const Equation& of, int which);
  /// Without derivatives that hold another letter, and with `dX` as the derivative along u or v. Nothing
  /// where the order of repeated derivatives would matter, which a symbol does not keep.
  [[nodiscard]] std::optional<Equation> rewritten(const Equation& equation, int which = 0);
  /// The Jacobians by which was divided.
  [[nodiscard]] const std::vector<ExprId>& divisors() const { return divisors_; }
  [[nodiscard]] bool gave_up() const { return budget_.exceeded.has_value(); }

 private:
  Differentiator differentiator(int which);
  std::optional<ExprId> of_derivative(ExprId node, int which);
  ExprId with_held(ExprId of, const Variable& by, Span span);
  ExprId letter(SymbolId symbol, Span span);
  ExprId jacobian(ExprId f, ExprId g, Span span);

  ExprTree& tree_;
  Coordinates coordinates_;
  std::set<SymbolId> states_;
  DerivativeBudget budget_;
  std::array<Differentiator, 2> by_;
  std::vector<ExprId> divisors_;
};

}  // namespace rigor
