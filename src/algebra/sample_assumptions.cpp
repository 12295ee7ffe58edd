// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample_assumptions.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "algebra/sample_linear.h"

namespace rigor {
namespace {

[[nodiscard]] bool contains(const std::vector<SymbolId>& symbols, SymbolId symbol) {
  return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

constexpr std::uint32_t order_passes = 4;
constexpr int equation_passes = 4;
constexpr double largest_solved = 200;  // bits: a sample is to be read, and to be checked fast

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
    Reach reached = reach(scope, scope.question().assumptions[position]);
    has_particle_sums_ = has_particle_sums_ || reached.particle_sums;
    symbols_.push_back(std::move(reached.symbols));
    if (scope.question().assumptions[position].relation != Relation::equal) has_orders_ = true;
  }
  for (std::size_t i = symbols_.size(); i-- > 0;) order_symbols(i);
}

bool AssumptionSolver::is_side(std::size_t assumption, SymbolId symbol) const {
  const ExprTree& tree = scope_->tree();
  const auto is_it = [&](ExprId side) { return tree[side].op == Op::symbol && tree[side].symbol == symbol; };
  return is_it(equation(assumption).left) || is_it(equation(assumption).right);
}

void AssumptionSolver::order_symbols(std::size_t assumption) {
  const auto preference = [&](SymbolId symbol) {
    const Symbol& named = scope_->tree().symbols[symbol];
    bool earlier = false;
    bool elsewhere = false;
    for (std::size_t i = 0; i < symbols_.size(); ++i) {
      if (i == assumption || !contains(symbols_[i], symbol)) continue;
      elsewhere = true;
      earlier = earlier || i < assumption;
    }
    return std::tuple(!elsewhere, !earlier, is_side(assumption, symbol), named.per_particle, named.rank);
  };
  std::vector<SymbolId>& symbols = symbols_[assumption];
  std::stable_sort(symbols.begin(), symbols.end(),
                   [&](SymbolId a, SymbolId b) { return preference(a) > preference(b); });
}

bool AssumptionSolver::holds(SampleEvaluator& evaluator, const SamplePoint& point) const {
  evaluator.look_at(point);
  return std::all_of(assumptions_.begin(), assumptions_.end(), [&](std::size_t position) {
    return evaluator.holds(scope_->question().assumptions[position]);
  });
}

/// The numbers of an assumption's symbols, the most promising first.
std::vector<Coordinate> AssumptionSolver::candidates(const SamplePoint& point, std::size_t assumption,
                                                     std::uint32_t attempt) const {
  const ExprTree& tree = scope_->tree();
  std::vector<Coordinate> found;
  for (const Coordinate& at : point.coordinates()) {
    if (contains(symbols_[assumption], at.symbol) && point.is_free(at)) found.push_back(at);
  }
  const auto is_new = [&](SymbolId symbol) {
    const auto end = symbols_.begin() + static_cast<std::ptrdiff_t>(assumption);
    return std::none_of(symbols_.begin(), end,
                        [&](const auto& earlier) { return contains(earlier, symbol); });
  };
  const auto preference = [&](const Coordinate& at) {
    return std::tuple(is_new(at.symbol), is_side(assumption, at.symbol), at.particle,
                      tree.symbols[at.symbol].rank);
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

/// All components at once, for the numbers of one symbol, the last particle's first: by differences, and then
/// verified, since the assumption need not be linear in them.
bool AssumptionSolver::solve_for_symbol(Search& search, std::size_t assumption, SymbolId symbol,
                                        const std::vector<Rational>& residuals) const {
  SamplePoint changed = search.point;
  const auto residuals_of_changed = [&] {
    search.evaluator.look_at(changed);
    return search.evaluator.residuals(equation(assumption));
  };
  std::vector<Coordinate> unknowns;
  for (const Coordinate& at : changed.coordinates_of(symbol)) {
    const auto owner = std::find_if(search.owned.begin(), search.owned.end(),
                                    [&](const Owned& each) { return each.at == at; });
    const bool free = owner == search.owned.end() || owner->assumption == assumption;
    if (free && changed.is_free(at)) unknowns.push_back(at);
  }
  std::stable_sort(unknowns.begin(), unknowns.end(),
                   [](const Coordinate& a, const Coordinate& b) { return a.particle > b.particle; });
  LinearColumns columns;
  for (const Coordinate& at : unknowns) {
    const Rational before = changed[at];
    changed.set(at, before + 1);
    columns.push_back(residuals_of_changed());
    changed.set(at, before);
    for (std::size_t i = 0; i < residuals.size(); ++i) columns.back()[i] = residuals[i] - columns.back()[i];
  }
  const auto solution = solve_linear(std::move(columns), residuals);
  if (!solution) return false;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const Rational value = changed[unknowns[i]] + (*solution)[i];
    if (bit_size(value) > largest_solved) return false;
    changed.set(unknowns[i], value);
  }
  const std::vector<Rational> left = residuals_of_changed();
  if (!std::all_of(left.begin(), left.end(), [](const Rational& each) { return cln::zerop(each); }))
    return false;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    if (!cln::zerop((*solution)[i])) search.owned.push_back({unknowns[i], assumption});
  }
  search.point = std::move(changed);
  return true;
}

/// The components one after the other, each for any one number in which it is linear.
bool AssumptionSolver::solve_place_by_place(Search& search, std::size_t assumption) const {
  search.evaluator.look_at(search.point);
  for (const Place& place : search.evaluator.places(equation(assumption))) {
    const Residual residual(search.evaluator, search.point, equation(assumption), place);
    if (cln::zerop(residual.now())) continue;
    bool solved = false;
    for (const Coordinate& at : candidates(search.point, assumption, search.attempt)) {
      const bool owned = std::any_of(search.owned.begin(), search.owned.end(),
                                     [&](const Owned& each) { return each.at == at; });
      if (owned || !residual.solve_for(at, 0)) continue;
      if (bit_size(search.point[at]) > largest_solved) return false;
      search.owned.push_back({at, assumption});
      solved = true;
      break;
    }
    if (!solved) return false;
  }
  return true;
}

bool AssumptionSolver::solve_equation(Search& search, std::size_t assumption) const {
  search.evaluator.look_at(search.point);
  const std::vector<Rational> residuals = search.evaluator.residuals(equation(assumption));
  if (std::all_of(residuals.begin(), residuals.end(), [](const Rational& each) { return cln::zerop(each); }))
    return true;
  const std::vector<SymbolId>& symbols = symbols_[assumption];
  const std::size_t first = search.attempt % 4 == 3 ? search.attempt / 4 % symbols.size() : 0;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    try {
      if (solve_for_symbol(search, assumption, symbols[(first + i) % symbols.size()], residuals)) return true;
    } catch (const PointRejected&) {
      // not a polynomial in these numbers: others may do
    }
  }
  return solve_place_by_place(search, assumption);
}

/// Solves the equations among the assumptions that do not hold yet; false if one could not be solved.
bool AssumptionSolver::solve_equations(SampleEvaluator& evaluator, SamplePoint& point,
                                       std::uint32_t attempt) const {
  Search search{evaluator, point, attempt};
  for (int pass = 0; pass < equation_passes; ++pass) {
    for (std::size_t i = 0; i < assumptions_.size(); ++i) {
      if (equation(i).relation != Relation::equal) continue;
      if (!symbols_[i].empty() && !solve_equation(search, i)) return false;
    }
    if (has_orders_ || holds(evaluator, point)) return true;
  }
  return false;
}

/// Puts the sides that are not in order yet at a small distance. The passes try the numbers in both
/// directions.
void AssumptionSolver::solve_orders(SampleEvaluator& evaluator, SamplePoint& point,
                                    std::uint32_t turn) const {
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    const Equation& order = equation(i);
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
    if (solve_equations(evaluator, point, attempt) && holds(evaluator, point)) return true;
  }
  return false;
}

}  // namespace rigor
