// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_assumptions.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "algebra/sample/sample_linear.h"
#include "base/among.h"

namespace rigor {
namespace {

[[nodiscard]] bool all_zero(const std::vector<Rational>& values) {
  return std::ranges::all_of(values, [](const Rational& each) { return cln::zerop(each); });
}

constexpr std::uint32_t order_passes = 4;
constexpr int equation_passes = 4;
constexpr double largest_solved = 200;  // bits: a sample is to be read, and to be checked fast

/// Distances between sides that an order keeps apart.
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
    return rational_of(sides.left) - rational_of(sides.right);
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

  /// Makes the residual 0 by this number if it is a quotient of two linear functions of it, as
  /// `1/f - 1/a - 1/b` is of each; else leaves it. Such a function keeps cross-ratios, so that three of its
  /// values say where it is 0. What it says is put in, since the function need not be one.
  [[nodiscard]] bool solve_quotient_for(const Coordinate& at) const {
    const Rational before = point_[at];
    std::vector<std::pair<Rational, Rational>> seen;
    for (const int number : {1, 2, 3, -1, 5}) {
      if (seen.size() == 3) break;
      const auto value = value_with(at, number);
      if (value && !cln::zerop(*value)) seen.emplace_back(number, *value);
    }
    if (const auto zero = zero_of_quotient(seen)) {
      const auto value = value_with(at, *zero);
      if (value && cln::zerop(*value)) return true;
    }
    point_.set(at, before);
    return false;
  }

  [[nodiscard]] bool is_quadratic_in(const Coordinate& at) const {
    const Rational before = point_[at];
    bool is_one = false;
    try {
      const Quadratic through = quadratic_through(with(at, 0), with(at, 1), with(at, -1));
      is_one = !cln::zerop(through.square) &&
               with(at, 2) == through.constant + 2 * through.linear + 4 * through.square;
    } catch (const PointRejected&) {
      // not a polynomial in this number
    }
    point_.set(at, before);
    return is_one;
  }

  /// Makes the residual 0 by two numbers if it is of second degree in them and a curve with rational points:
  /// with rational asymptotes, as `E^2 - p^2c^2 - m^2c^4` in E and p, or where the second number alone does,
  /// as y in `x^2/a^2 + y^2/b^2 - 1`.
  [[nodiscard]] bool solve_for_both(const Coordinate& one, const Coordinate& other) const {
    const Rational before[] = {point_[one], point_[other]};
    const auto solves = [&](auto method, const Coordinate& first, const Coordinate& second) {
      try {
        return (this->*method)(first, second);
      } catch (const PointRejected&) {
        return false;  // not a polynomial in these numbers
      }
    };
    if (solves(&Residual::solve_along_asymptote, one, other) ||
        solves(&Residual::solve_from_a_point, one, other) ||
        solves(&Residual::solve_from_a_point, other, one))
      return true;
    point_.set(one, before[0]);
    point_.set(other, before[1]);
    return false;
  }

  /// The value of the number at which the residual is 0, and how it rises; none where it is not linear in it.
  struct Zero {
    Rational at;
    Rational slope;
  };
  [[nodiscard]] std::optional<Zero> zero(const Coordinate& at) const {
    const Rational before = point_[at];
    std::optional<Zero> found;
    try {
      const Rational at_0 = with(at, 0);
      const Rational slope = with(at, 1) - at_0;
      if (!cln::zerop(slope) && with(at, 2) - at_0 == 2 * slope) found = Zero{-at_0 / slope, slope};
    } catch (const PointRejected&) {
      // not a polynomial in this number
    }
    point_.set(at, before);
    return found;
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

  [[nodiscard]] Rational with_both(const Coordinate& one, const Rational& x, const Coordinate& other,
                                   const Rational& y) const {
    point_.set(one, x);
    return with(other, y);
  }

  /// a + bx + cx^2
  struct Quadratic {
    Rational constant;
    Rational linear;
    Rational square;
  };

  /// Through its values at 0, 1 and -1.
  static Quadratic quadratic_through(const Rational& at_0, const Rational& at_1, const Rational& at_minus_1) {
    return {at_0, (at_1 - at_minus_1) / 2, (at_1 + at_minus_1) / 2 - at_0};
  }

  static std::vector<Rational> rational_roots(const Quadratic& of) {
    Rational root;
    const Rational discriminant = of.linear * of.linear - 4 * of.constant * of.square;
    if (cln::zerop(of.square) || cln::minusp(discriminant) || !cln::sqrtp(discriminant, &root)) return {};
    return {(root - of.linear) / (2 * of.square), (-root - of.linear) / (2 * of.square)};
  }

  /// Along the directions of the asymptotes the residual is linear.
  [[nodiscard]] bool solve_along_asymptote(const Coordinate& one, const Coordinate& other) const {
    const Rational x = point_[one];
    const Rational y = point_[other];
    const auto at = [&](const Rational& dx, const Rational& dy) {
      return with_both(one, x + dx, other, y + dy);
    };
    const Rational here = at(0, 0);
    const Rational along_one = at(1, 0);
    const Rational along_other = at(0, 1);
    const Rational of_one = (along_one + at(-1, 0)) / 2 - here;
    const Rational of_other = (along_other + at(0, -1)) / 2 - here;
    const Rational of_both = at(1, 1) - along_one - along_other + here;
    for (const Rational& slope : rational_roots({of_other, of_both, of_one})) {
      const Rational rise = at(slope, 1) - here;
      if (cln::zerop(rise)) continue;
      const Rational steps = -here / rise;
      if (cln::zerop(at(slope * steps, steps))) return true;
    }
    return false;
  }

  /// Where the first number is 0, the second may have a rational value; a line through this point meets the
  /// curve once more.
  [[nodiscard]] bool solve_from_a_point(const Coordinate& one, const Coordinate& other) const {
    const auto at_0 = [&](const Rational& y) { return with_both(one, 0, other, y); };
    for (const Rational& y : rational_roots(quadratic_through(at_0(0), at_0(1), at_0(-1)))) {
      for (const int slope : {2, -3, 1}) {  // not 1 first: on a circle that leads to where the other is 0
        const auto along = [&](const Rational& x) { return with_both(one, x, other, y + slope * x); };
        const Quadratic line = quadratic_through(along(0), along(1), along(-1));
        if (!cln::zerop(line.constant) || cln::zerop(line.linear) || cln::zerop(line.square)) continue;
        if (cln::zerop(along(-line.linear / line.square))) return true;
      }
    }
    return false;
  }

  /// Nothing: there is no value.
  [[nodiscard]] std::optional<Rational> value_with(const Coordinate& at, const Rational& value) const {
    try {
      return with(at, value);
    } catch (const PointRejected&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] static std::optional<Rational> zero_of_quotient(
      std::span<const std::pair<Rational, Rational>> seen) {
    if (seen.size() < 3) return std::nullopt;
    const auto& [x1, y1] = seen[0];
    const auto& [x2, y2] = seen[1];
    const auto& [x3, y3] = seen[2];
    if (y1 == y3 || y2 == y3 || y1 == y2) return std::nullopt;
    const Rational of_values = (y1 - y3) * y2 / ((y2 - y3) * y1);
    const Rational of_numbers = (x1 - x3) / (x2 - x3);
    if (of_values == of_numbers) return std::nullopt;
    return (of_values * x1 - of_numbers * x2) / (of_values - of_numbers);
  }

  SampleEvaluator& evaluator_;
  SamplePoint& point_;
  const Equation& equation_;
  const Place& place_;
};

/// Makes the residual 0 by one of the numbers, or by two; says which, or none.
std::vector<Coordinate> numbers_that_solve(const Residual& residual, std::span<const Coordinate> numbers) {
  for (const Coordinate& at : numbers) {
    if (residual.solve_for(at, 0)) return {at};
  }
  for (const Coordinate& at : numbers) {
    if (residual.solve_quotient_for(at)) return {at};
  }
  constexpr std::size_t most_paired = 4;
  std::vector<Coordinate> squared;
  std::ranges::copy_if(numbers.first(std::min(numbers.size(), most_paired)), std::back_inserter(squared),
                       [&](const Coordinate& at) { return residual.is_quadratic_in(at); });
  for (std::size_t i = 0; i < squared.size(); ++i) {
    for (std::size_t j = i + 1; j < squared.size(); ++j) {
      if (residual.solve_for_both(squared[i], squared[j])) return {squared[i], squared[j]};
    }
  }
  return {};
}

}  // namespace

AssumptionSolver::AssumptionSolver(const Scope& scope, std::vector<std::size_t> assumptions)
    : scope_(&scope), assumptions_(std::move(assumptions)) {
  for (const std::size_t position : assumptions_) {
    Reach reached = reach(scope, scope.question().assumptions[position]);
    has_particle_sums_ = has_particle_sums_ || reached.particle_sums;
    int order = 0;
    for (const SymbolId symbol : reached.symbols)
      order = std::max(order, scope.tree().symbols[symbol].order());
    derivative_orders_.push_back(order);
    has_tensors_ =
        has_tensors_ ||
        (scope.question().assumptions[position].relation == Relation::equal &&
         std::ranges::any_of(reached.symbols, [&](SymbolId symbol) { return is_free_tensor(symbol); }));
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
      if (i == assumption || !is_one_of(symbol, symbols_[i])) continue;
      elsewhere = true;
      earlier = earlier || i < assumption;
    }
    return std::tuple(!elsewhere, !earlier, is_side(assumption, symbol), named.per_particle, named.rank);
  };
  std::vector<SymbolId>& symbols = symbols_[assumption];
  std::ranges::stable_sort(symbols, [&](SymbolId a, SymbolId b) { return preference(a) > preference(b); });
}

bool AssumptionSolver::holds(SampleEvaluator& evaluator, const SamplePoint& point) const {
  evaluator.look_at(point);
  return std::ranges::all_of(assumptions_, [&](std::size_t position) {
    return evaluator.holds(scope_->question().assumptions[position]);
  });
}

/// The numbers of an assumption's symbols, the most promising first.
std::vector<Coordinate> AssumptionSolver::candidates(const SamplePoint& point, std::size_t assumption,
                                                     std::uint32_t attempt) const {
  const ExprTree& tree = scope_->tree();
  std::vector<Coordinate> found;
  for (const Coordinate& at : point.coordinates()) {
    if (is_one_of(at.symbol, symbols_[assumption]) && point.is_free(at)) found.push_back(at);
  }
  const auto is_new = [&](SymbolId symbol) {
    const auto end = symbols_.begin() + static_cast<std::ptrdiff_t>(assumption);
    return std::none_of(symbols_.begin(), end,
                        [&](const auto& earlier) { return is_one_of(symbol, earlier); });
  };
  const auto preference = [&](const Coordinate& at) {
    return std::tuple(is_new(at.symbol), is_side(assumption, at.symbol), at.particle,
                      tree.symbols[at.symbol].rank);
  };
  std::ranges::stable_sort(
      found, [&](const Coordinate& a, const Coordinate& b) { return preference(a) > preference(b); });
  if (!found.empty()) {
    const auto turn =
        static_cast<std::ptrdiff_t>(attempt * 3 % found.size());  // the first is tried in three of four
    if (attempt % 4 == 3) std::rotate(found.begin(), found.begin() + turn, found.end());
  }
  return found;
}

std::vector<Rational> AssumptionSolver::residuals_at(const Search& search, const SamplePoint& point,
                                                     std::size_t assumption) const {
  search.evaluator.look_at(point);
  return search.evaluator.residuals(equation(assumption));
}

/// All components at once, for the numbers of some symbols, the last particle's first: by differences, and
/// then verified, since the assumptions need not be linear in them. `residuals`: of each of the assumptions
/// at the point as it is.
bool AssumptionSolver::solve_together(Search& search, std::span<const std::size_t> assumptions,
                                      std::span<const SymbolId> symbols,
                                      const std::vector<std::vector<Rational>>& residuals) const {
  SamplePoint changed = search.point;
  const auto residuals_of = [&](std::size_t assumption) { return residuals_at(search, changed, assumption); };
  std::vector<Rational> right;
  for (const std::vector<Rational>& each : residuals) right.insert(right.end(), each.begin(), each.end());
  if (all_zero(right)) return true;
  const std::vector<Coordinate> unknowns = unknowns_of(search, assumptions, symbols);
  LinearColumns columns;
  for (const Coordinate& at : unknowns) {
    std::vector<Rational>& column = columns.emplace_back();
    const Rational before = changed[at];
    changed.set(at, before + 1);
    for (std::size_t i = 0; i < assumptions.size(); ++i) {
      if (!is_one_of(at.symbol, symbols_[assumptions[i]])) {
        column.insert(column.end(), residuals[i].size(), 0);
        continue;
      }
      const std::vector<Rational> moved = residuals_of(assumptions[i]);
      for (std::size_t k = 0; k < moved.size(); ++k) column.push_back(residuals[i][k] - moved[k]);
    }
    changed.set(at, before);
  }
  const auto solution = solve_linear(std::move(columns), std::move(right));
  if (!solution) return false;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const Rational value = changed[unknowns[i]] + (*solution)[i];
    if (bit_size(value) > largest_solved) return false;
    changed.set(unknowns[i], value);
  }
  for (const std::size_t assumption : assumptions) {
    if (!all_zero(residuals_of(assumption))) return false;
  }
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    if (!cln::zerop((*solution)[i])) search.owned.push_back({unknowns[i], assumptions.front()});
  }
  search.point = std::move(changed);
  return true;
}

/// The numbers that may change: those that no other assumption was solved for.
std::vector<Coordinate> AssumptionSolver::unknowns_of(const Search& search,
                                                      std::span<const std::size_t> assumptions,
                                                      std::span<const SymbolId> symbols) const {
  const auto is_taken = [&](const Coordinate& at) {
    return std::ranges::any_of(search.owned, [&](const Owned& each) {
      return each.at == at && !is_one_of(each.assumption, assumptions);
    });
  };
  std::vector<Coordinate> unknowns;
  for (const SymbolId symbol : symbols) {
    for (const Coordinate& at : search.point.coordinates_of(symbol)) {
      if (search.point.is_free(at) && !is_taken(at)) unknowns.push_back(at);
    }
  }
  std::ranges::stable_sort(unknowns, std::ranges::greater{}, &Coordinate::particle);
  return unknowns;
}

/// The differential equations of an order together, for the derivatives of that order: in every other
/// attempt.
void AssumptionSolver::solve_derivatives(Search& search, int order) const {
  std::vector<std::size_t> together;
  std::vector<SymbolId> symbols;
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    if (derivative_orders_[i] != order || equation(i).relation != Relation::equal) continue;
    together.push_back(i);
    for (const SymbolId symbol : symbols_[i]) {
      if (scope_->tree().symbols[symbol].order() == order && !is_one_of(symbol, symbols))
        symbols.push_back(symbol);
    }
  }
  if (together.size() < 2) return;
  try {
    std::vector<std::vector<Rational>> residuals;
    for (const std::size_t each : together) residuals.push_back(residuals_at(search, search.point, each));
    static_cast<void>(solve_together(search, together, symbols, residuals));
  } catch (const PointRejected&) {
    // not polynomials in these numbers: each for itself may do
  }
}

/// The components one after the other, each for any one number in which it is linear, or a quotient of two
/// linear functions; else for two in which it is of second degree.
bool AssumptionSolver::solve_place_by_place(Search& search, std::size_t assumption) const {
  search.evaluator.look_at(search.point);
  for (const Place& place : search.evaluator.places(equation(assumption))) {
    const Residual residual(search.evaluator, search.point, equation(assumption), place);
    if (cln::zerop(residual.now())) continue;
    std::vector<Coordinate> numbers = candidates(search.point, assumption, search.attempt);
    std::erase_if(numbers, [&](const Coordinate& at) {
      return std::ranges::any_of(search.owned, [&](const Owned& each) { return each.at == at; });
    });
    const std::vector<Coordinate> changed = numbers_that_solve(residual, numbers);
    if (changed.empty()) return false;
    for (const Coordinate& at : changed) {
      if (bit_size(search.point[at]) > largest_solved) return false;
      search.owned.push_back({at, assumption});
    }
  }
  return true;
}

bool AssumptionSolver::solve_equation(Search& search, std::size_t assumption) const {
  const std::vector<SymbolId>& symbols = symbols_[assumption];
  const std::size_t first = search.attempt % 4 == 3 ? search.attempt / 4 % symbols.size() : 0;
  std::vector<std::vector<Rational>> residuals;
  try {
    residuals.push_back(residuals_at(search, search.point, assumption));
  } catch (const PointRejected&) {
    return solve_place_by_place(search, assumption);
  }
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    try {
      const SymbolId symbol = symbols[(first + i) % symbols.size()];
      if (solve_together(search, std::span(&assumption, 1), std::span(&symbol, 1), residuals)) return true;
    } catch (const PointRejected&) {
      // not a polynomial in these numbers: others may do
    }
  }
  return solve_place_by_place(search, assumption);
}

/// Solves the equations among the assumptions that do not hold yet; in every other attempt those of low
/// orders first, and those of one order together. False if one could not be solved.
bool AssumptionSolver::solve_equations(SampleEvaluator& evaluator, SamplePoint& point,
                                       std::uint32_t attempt) const {
  Search search{evaluator, point, attempt};
  const bool by_orders = attempt % 2 == 1;
  const int highest = by_orders ? std::ranges::max(derivative_orders_) : 0;
  for (int pass = 0; pass < equation_passes; ++pass) {
    for (int order = 0; order <= highest; ++order) {
      if (order > 0) solve_derivatives(search, order);
      for (std::size_t i = 0; i < assumptions_.size(); ++i) {
        if (equation(i).relation != Relation::equal || symbols_[i].empty()) continue;
        if (by_orders && derivative_orders_[i] != order) continue;
        if (!solve_equation(search, i)) return false;
      }
    }
    if (has_orders_ || holds(evaluator, point)) return true;
  }
  return false;
}

/// Where the orders leave a number: between what bounds it from below and from above, as far as they are
/// linear in it; the two as far apart as they are, so that 0 < x < 10^{-8} has samples, and 0 < a < b.
struct AssumptionSolver::Interval {
  std::optional<Rational> below;
  std::optional<Rational> above;

  [[nodiscard]] bool is_empty() const { return below && above && !(*below < *above); }
  /// In the part of it that the turn says; without two bounds, at a small distance from the one.
  [[nodiscard]] Rational number(std::uint32_t turn) const {
    constexpr std::uint32_t parts = 20;  // 1/2 first
    if (below && above)
      return *below + (*above - *below) * static_cast<int>((7 * turn + 9) % (parts - 1) + 1) / parts;
    const Rational& distance = distances()[turn % distances().size()];
    return below ? *below + distance : *above - distance;
  }
};

AssumptionSolver::Interval AssumptionSolver::interval_of(SampleEvaluator& evaluator, SamplePoint& point,
                                                         const Coordinate& at) const {
  Interval interval;
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    const Equation& order = equation(i);
    const bool bounds = order.relation == Relation::less || order.relation == Relation::less_or_equal;
    if (!bounds || !is_one_of(at.symbol, symbols_[i])) continue;
    evaluator.look_at(point);
    for (const Place& place : evaluator.places(order)) {
      const auto zero = Residual(evaluator, point, order, place).zero(at);
      if (!zero) continue;  // left − right has to be negative
      std::optional<Rational>& bound = cln::plusp(zero->slope) ? interval.above : interval.below;
      const bool narrower = !bound || (cln::plusp(zero->slope) ? zero->at < *bound : *bound < zero->at);
      if (narrower) bound = zero->at;
    }
  }
  return interval;
}

/// Puts the number between the sides of all orders at once, if that can be.
bool AssumptionSolver::put_between(SampleEvaluator& evaluator, SamplePoint& point, const Coordinate& at,
                                   std::uint32_t turn) const {
  const Interval interval = interval_of(evaluator, point, at);
  if (interval.is_empty() || (!interval.below && !interval.above)) return false;
  const Rational value = interval.number(turn);
  if (bit_size(value) > largest_solved) return false;
  point.set(at, value);
  return true;
}

/// Puts the sides that are not in order yet at a small distance, or between those of all orders. The passes
/// try the numbers in both directions.
void AssumptionSolver::solve_orders(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t turn,
                                    bool between) const {
  for (std::size_t i = 0; i < assumptions_.size(); ++i) {
    const Equation& order = equation(i);
    if (order.relation == Relation::equal) continue;
    evaluator.look_at(point);
    for (const Place& place : evaluator.places(order)) {
      const Residual residual(evaluator, point, order, place);
      if (is_related(residual.now(), order.relation, 0)) continue;
      std::vector<Coordinate> choices = candidates(point, i, 0);
      if (turn % 2 == 1) std::ranges::reverse(choices);
      for (const Coordinate& at : choices) {
        if (between && put_between(evaluator, point, at, turn)) break;
        if (symbols_[i].size() == 1 && residual.reflect(at)) break;
        if (residual.solve_for(at, -distances()[turn % distances().size()])) break;
      }
    }
  }
}

/// The unit matrix, an exchange of two axes, a turn of 3, 4 and 5, nothing at all: what an equation between
/// products of tensors is most often about, R_ik R_jk = δ_ij first of all.
void AssumptionSolver::put_known_tensors(SamplePoint& point, std::uint32_t attempt) const {
  const Rational three = Rational(3) / 5;
  const Rational four = Rational(4) / 5;
  const std::vector<std::vector<Rational>> known{
      {1, 0, 0, 0, 1, 0, 0, 0, 1}, {three, -four, 0, four, three, 0, 0, 0, 1},
      {0, 1, 0, 0, 0, 1, 1, 0, 0}, {1, 0, 0, 0, three, four, 0, four, -three},
      {0, 1, 0, 1, 0, 0, 0, 0, 1}, {1, 0, 0, 0, -1, 0, 0, 0, 1},
      {0, 0, 0, 0, 0, 0, 0, 0, 0}};
  std::size_t turn = attempt;
  for (const SymbolId symbol : point.symbols()) {
    if (!is_free_tensor(symbol)) continue;
    const std::vector<Rational>& entries = known[turn++ % known.size()];
    for (const Coordinate& at : point.coordinates_of(symbol)) {
      if (point.is_free(at)) point.set(at, entries[at.component]);
    }
  }
}

bool AssumptionSolver::is_free_tensor(SymbolId symbol) const {
  const Symbol& named = scope_->tree().symbols[symbol];
  return named.rank == 2 && !named.rotation && named.axes.are_common();  // the known ones are of three rows
}

bool AssumptionSolver::solve(SampleEvaluator& evaluator, SamplePoint& point, std::uint32_t attempt) const {
  if (!has_tensors_) return solve_as_drawn(evaluator, point, attempt);
  SamplePoint known = point;
  try {
    if (solve_as_drawn(evaluator, point, attempt)) return true;
  } catch (const PointRejected&) {
    // the tensors that are known may do
  }
  put_known_tensors(known, attempt);
  point = std::move(known);
  return solve_as_drawn(evaluator, point, attempt);
}

bool AssumptionSolver::solve_as_drawn(SampleEvaluator& evaluator, SamplePoint& point,
                                      std::uint32_t attempt) const {
  for (std::uint32_t pass = 0; pass < (has_orders_ ? order_passes : 1); ++pass) {
    if (has_orders_) solve_orders(evaluator, point, attempt + pass, pass >= order_passes / 2);
    if (solve_equations(evaluator, point, attempt) && holds(evaluator, point)) return true;
  }
  return false;
}

}  // namespace rigor
