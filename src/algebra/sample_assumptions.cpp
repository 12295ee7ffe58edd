// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample_assumptions.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rigor {
namespace {

[[nodiscard]] bool contains(const std::vector<SymbolId>& symbols, SymbolId symbol) {
  return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

constexpr std::uint32_t order_passes = 4;

/// Of sides that an order holds apart.
[[nodiscard]] const std::vector<Rational>& distances() {
  static const std::vector<Rational> all{1, 2, 1, Rational(1) / 2, 3};
  return all;
}

/// left − right at a place, as a function of one number of the sample.
class Residual {
 public:
  Residual(SampleEvaluator& evaluator, SamplePoint& point, const Equation& equation, const Place& place)
      : evaluator_(evaluator), point_(point), equation_(equation), place_(place) {}

  [[nodiscard]] Rational now() const {
    evaluator_.look_at(point_);
    const Difference sides = evaluator_.at(equation_, place_);
    return sides.left - sides.right;
  }

  /// Gives the residual a value by this number if it is linear in it; else leaves it.
  [[nodiscard]] bool solve_for(const Coordinate& at, const Rational& wanted) const {
    const Rational before = point_[at];
    try {
      const Rational at_0 = with(at, 0);
      const Rational slope = with(at, 1) - at_0;
      if (!cln::zerop(slope) && with(at, 2) - at_0 == 2 * slope) {
        point_.set(at, (wanted - at_0) / slope);
        return true;
      }
    } catch (const PointRejected&) {
      // not a polynomial in this number: another one may do
    }
    point_.set(at, before);
    return false;
  }

  /// Changes the number's sign if that brings the sides into order.
  [[nodiscard]] bool reflect(const Coordinate& at) const {
    const Rational before = point_[at];
    if (is_related(with(at, -before), equation_.relation, 0)) return true;
    point_.set(at, before);
    return false;
  }

 private:
  [[nodiscard]] Rational with(const Coordinate& at, const Rational& value) const {
    point_.set(at, value);
    return now();
  }

  SampleEvaluator& evaluator_;
  SamplePoint& point_;
  const Equation& equation_;
  const Place& place_;
};

}  // namespace

AssumptionSolver::AssumptionSolver(const Scope& scope, std::vector<std::size_t> assumptions)
    : scope_(&scope), assumptions_(std::move(assumptions)) {
  for (const std::size_t position : assumptions_) {
    symbols_.push_back(reach(scope, scope.question().assumptions[position]).symbols);
    if (scope.question().assumptions[position].relation != Relation::equal) has_orders_ = true;
  }
}

bool AssumptionSolver::holds(SampleEvaluator& evaluator, const SamplePoint& point) const {
  evaluator.look_at(point);
  return std::all_of(assumptions_.begin(), assumptions_.end(), [&](std::size_t position) {
    return evaluator.holds(scope_->question().assumptions[position]);
  });
}

std::vector<Coordinate> AssumptionSolver::candidates(const SamplePoint& point, std::size_t assumption,
                                                     std::uint32_t attempt) const {
  const ExprTree& tree = scope_->tree();
  const Equation& equation = scope_->question().assumptions[assumptions_[assumption]];
  const auto is_side = [&](SymbolId symbol) {
    const auto is_it = [&](ExprId side) {
      return tree[side].op == Op::symbol && tree[side].symbol == symbol;
    };
    return is_it(equation.left) || is_it(equation.right);
  };
  std::vector<Coordinate> found;
  for (const Coordinate& at : point.coordinates()) {
    if (contains(symbols_[assumption], at.symbol) && !point.is_whole(at) &&
        point.meaning(at.symbol).kind == Meaning::Kind::itself)
      found.push_back(at);
  }
  const auto is_new = [&](SymbolId symbol) {
    const auto end = symbols_.begin() + static_cast<std::ptrdiff_t>(assumption);
    return std::none_of(symbols_.begin(), end,
                        [&](const auto& earlier) { return contains(earlier, symbol); });
  };
  const auto preference = [&](const Coordinate& at) {
    return std::tuple(is_new(at.symbol), is_side(at.symbol), at.particle, tree.symbols[at.symbol].rank);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Coordinate& a, const Coordinate& b) { return preference(a) > preference(b); });
  if (!found.empty()) {
    const auto turn =
        static_cast<std::ptrdiff_t>(attempt * 3 % found.size());  // the first is tried in three of four
    if (attempt % 4 == 3) std::rotate(found.begin(), found.begin() + turn, found.end());
  }
  return found;
}

/// Solves the equations among the assumptions that do not hold yet.
void AssumptionSolver::solve_equations(SampleEvaluator& evaluator, SamplePoint& point,
                                       std::uint32_t attempt) const {
  std::vector<Coordinate> solved;
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    const Equation& equation = scope_->question().assumptions[assumptions_[i]];
    if (equation.relation != Relation::equal) continue;
    evaluator.look_at(point);
    for (const Place& place : evaluator.places(equation)) {
      const Residual residual(evaluator, point, equation, place);
      if (cln::zerop(residual.now())) continue;
      for (const Coordinate& at : candidates(point, i, attempt)) {
        if (std::find(solved.begin(), solved.end(), at) != solved.end()) continue;
        if (!residual.solve_for(at, 0)) continue;
        solved.push_back(at);
        break;
      }
    }
  }
}

/// Puts the sides that are not in order yet at a small distance. The passes try the numbers in both
/// directions.
void AssumptionSolver::solve_orders(SampleEvaluator& evaluator, SamplePoint& point,
                                    std::uint32_t turn) const {
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    const Equation& order = scope_->question().assumptions[assumptions_[i]];
    if (order.relation == Relation::equal) continue;
    evaluator.look_at(point);
    for (const Place& place : evaluator.places(order)) {
      const Residual residual(evaluator, point, order, place);
      if (is_related(residual.now(), order.relation, 0)) continue;
      std::vector<Coordinate> choices = candidates(point, i, 0);
      if (turn % 2 == 1) std::reverse(choices.begin(), choices.end());
      for (const Coordinate& at : choices) {
        if (symbols_[i].size() == 1 && residual.reflect(at)) break;
        if (residual.solve_for(at, -distances()[turn % distances().size()])) break;
      }
    }
  }
}

bool AssumptionSolver::solve(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t attempt) const {
  for (std::uint32_t pass = 0; pass < (has_orders_ ? order_passes : 1); ++pass) {
    if (has_orders_) solve_orders(evaluator, point, attempt + pass);
    solve_equations(evaluator, point, attempt);
    if (holds(evaluator, point)) return true;
  }
  return false;
}

}  // namespace rigor
