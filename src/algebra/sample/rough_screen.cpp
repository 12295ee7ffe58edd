// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/rough_screen.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "algebra/evaluator/components.h"
#include "algebra/evaluator/evaluator.h"
#include "algebra/parts/real_parts.h"
#include "algebra/point/scope.h"
#include "algebra/words/operator_question.h"
#include "base/splitmix.h"
#include "expr/statement/closed_question.h"

namespace rigor {
namespace {

constexpr int most_numbers = 128;
constexpr std::size_t most_rough_equations = 160;
constexpr std::uint64_t most_steps = 60'000;  // of evaluation, for all points
constexpr std::uint32_t rough_particles = 2;
constexpr int most_draws = 4;
constexpr int wanted_rough_points = 2;
constexpr int most_corrections = 40;  // a double root takes one for each bit
constexpr double holds_within = 1e-12;
constexpr double differs_by = 1e-4;  // relative to the sides, and absolute: numbers are drawn near 1
constexpr double largest_step = 2;
constexpr double clear_step = 1e-3;  // a point that is nearer to where the claim holds tells nothing

using Slope = Eigen::VectorXd;  // on the heap: the evaluator holds many of them, one inside the other

/// A value and how it changes with each number of the point; no slope at all: not at all.
struct Sloped {
  double value = 0;
  Slope slope = {};
};

[[nodiscard]] Sloped through(double value, double rate, const Slope& slope) {
  return slope.size() == 0 ? Sloped{value, {}} : Sloped{value, rate * slope};
}

[[nodiscard]] Slope sum_of(double a, const Slope& x, double b, const Slope& y) {
  if (x.size() == 0) return y.size() == 0 ? Slope() : Slope(b * y);
  return y.size() == 0 ? Slope(a * x) : Slope(a * x + b * y);
}

/// Where the numbers of the free symbols are in the vector of all.
class Layout {
 public:
  Layout(const ExprTree& tree, const Reach& reached) : tree_(tree) {
    for (const SymbolId symbol : reached.symbols) {
      const Symbol& named = tree.symbols[symbol];
      const std::size_t count = rigor::component_count(named);
      first_.emplace(static_cast<std::uint32_t>(symbol), size_);
      size_ += count * (named.per_particle ? rough_particles : 1);
    }
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t place(SymbolId symbol, std::uint32_t particle, std::size_t component) const {
    const Symbol& named = tree_.symbols[symbol];
    const std::size_t copy = particle == 0 ? 0 : particle - 1;
    return first_.at(static_cast<std::uint32_t>(symbol)) + copy * rigor::component_count(named) +
           canonical_component(named, component);
  }

 private:
  const ExprTree& tree_;
  std::unordered_map<std::uint32_t, std::size_t> first_;
  std::size_t size_ = 0;
};

/// Doubles with their slopes, as a Domain of `Evaluator`. The point is rejected where a value is no number.
class SlopedDomain {
 public:
  using Number = Sloped;

  SlopedDomain(const Layout& layout, Budget* budget) : layout_(layout), budget_(budget) {}

  void look_at(const Eigen::VectorXd& point) {
    point_ = &point;
    rejected_ = false;
  }
  [[nodiscard]] bool is_rejected() const { return rejected_; }

  [[nodiscard]] Sloped number(const std::string& digits) {
    return {std::strtod(digits.c_str(), nullptr), {}};
  }
  [[nodiscard]] Sloped integer(int value) { return {static_cast<double>(value), {}}; }
  /// A 0 that stays 0.
  [[nodiscard]] bool is_zero(const Sloped& x) { return x.value == 0 && x.slope.size() == 0; }
  void add(Sloped& total, const Sloped& x) {
    total.value += x.value;
    total.slope = sum_of(1, total.slope, 1, x.slope);
  }
  void negate(Sloped& x) { x = through(-x.value, -1, x.slope); }
  [[nodiscard]] Sloped multiply(const Sloped& a, const Sloped& b) {
    return {a.value * b.value, sum_of(b.value, a.slope, a.value, b.slope)};
  }
  [[nodiscard]] Sloped divide(const Sloped& a, const Sloped& b) {
    const double quotient = a.value / b.value;
    return checked({quotient, sum_of(1 / b.value, a.slope, -quotient / b.value, b.slope)});
  }
  [[nodiscard]] Sloped power(const Sloped& x, int exponent) {
    const double lower = std::pow(x.value, exponent - 1);
    return checked(through(lower * x.value, exponent * lower, x.slope));
  }
  [[nodiscard]] Sloped real_power(const Sloped& base, const Sloped& exponent) {
    return function(Function::exp, multiply(exponent, function(Function::log, base)));
  }
  [[nodiscard]] Sloped root(const Sloped& square) {
    const double root = std::sqrt(square.value);
    return checked(through(root, 0.5 / root, square.slope));
  }
  [[nodiscard]] Sloped even_power_of_root(const Sloped& square, int exponent) {
    check_root(square);
    return power(square, exponent / 2);
  }
  void check_root(const Sloped& square) { rejected_ = rejected_ || square.value < 0; }
  [[nodiscard]] Sloped function(Function function, const Sloped& x) {
    const double v = x.value;
    switch (function) {
      case Function::sin:
        return through(std::sin(v), std::cos(v), x.slope);
      case Function::cos:
        return through(std::cos(v), -std::sin(v), x.slope);
      case Function::exp:
        return checked(through(std::exp(v), std::exp(v), x.slope));
      case Function::log:
        return checked(through(std::log(v), 1 / v, x.slope));
      case Function::arcsin:
        return checked(through(std::asin(v), 1 / std::sqrt(1 - v * v), x.slope));
      case Function::arccos:
        return checked(through(std::acos(v), -1 / std::sqrt(1 - v * v), x.slope));
      case Function::arctan:
        return through(std::atan(v), 1 / (1 + v * v), x.slope);
    }
    return checked({std::numeric_limits<double>::quiet_NaN(), {}});
  }
  [[nodiscard]] Sloped circle_number() { return {std::numbers::pi, {}}; }
  [[nodiscard]] Sloped value(SymbolId symbol, std::uint32_t particle, std::size_t component) {
    const auto place = static_cast<Eigen::Index>(layout_.place(symbol, particle, component));
    return {(*point_)[place], Slope::Unit(static_cast<Eigen::Index>(layout_.size()), place)};
  }
  template <class Body>
  [[nodiscard]] std::vector<Sloped> particle_sum(std::size_t count, const Body& body) {
    std::vector<Sloped> total(count);
    for (std::uint32_t particle = 1; particle <= rough_particles; ++particle) {
      const std::vector<Sloped> term = body(particle);
      for (std::size_t i = 0; i < count; ++i) add(total[i], term[i]);
    }
    return total;
  }
  void settle(Sloped&) {}
  void step() {
    if (budget_ != nullptr) budget_->count(1);
    if (++steps_ > most_steps) throw Undecidable("no rough point was found in time");
  }

 private:
  [[nodiscard]] Sloped checked(Sloped x) {
    rejected_ = rejected_ || !std::isfinite(x.value) || !x.slope.allFinite();
    return x;
  }

  const Layout& layout_;
  Budget* budget_;
  const Eigen::VectorXd* point_ = nullptr;
  bool rejected_ = false;
  std::uint64_t steps_ = 0;
};

/// The sides of an equation in one component, for one choice of particles.
struct Sides {
  Sloped left;
  Sloped right;
  [[nodiscard]] double difference() const { return left.value - right.value; }
  [[nodiscard]] double size() const { return std::abs(left.value) + std::abs(right.value); }
  [[nodiscard]] bool agree() const { return std::abs(difference()) <= holds_within * (1 + size()); }
  [[nodiscard]] bool differ() const {
    return std::abs(difference()) > differs_by * size() && std::abs(difference()) > differs_by;
  }
};

class RoughScreen {
 public:
  RoughScreen(const Scope& scope, const Reach& reached, const std::vector<std::size_t>& assumptions,
              Budget* budget)
      : scope_(scope),
        symbols_(reached.symbols),
        assumptions_(assumptions),
        layout_(scope.tree(), reached),
        domain_(layout_, budget),
        evaluator_(scope, domain_) {}

  [[nodiscard]] bool fails() {
    if (layout_.size() == 0 || layout_.size() > static_cast<std::size_t>(most_numbers)) return false;
    int points = 0;
    for (int draw = 0; draw < most_draws && points < wanted_rough_points; ++draw) {
      Eigen::VectorXd point = drawn(draw);
      if (!move_onto_equations(point) || !keeps_orders(point)) continue;
      const auto claim = sides_of(scope_.question().claim, point);
      auto all = equations_at(point);
      if (!claim || !all) continue;
      if (std::ranges::none_of(*claim, &Sides::differ)) return false;
      // Where a divisor of the claim has become 0, the least step would do: `\mu \to 0` of 1/\mu.
      std::ranges::copy(*claim, std::back_inserter(*all));
      if (!(step_onto(*all, point).norm() >= clear_step)) continue;
      ++points;
    }
    return points == wanted_rough_points;
  }

 private:
  /// Positive scalars first: most quantities are.
  [[nodiscard]] Eigen::VectorXd drawn(int draw) {
    Eigen::VectorXd point(static_cast<Eigen::Index>(layout_.size()));
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random_.next() >> 11U) * 0x1p-53;
    };
    for (double& each : point) each = between(0.3, 1.9) * (draw > 1 && random_.below(2) == 0 ? -1 : 1);
    for (const SymbolId symbol : symbols_) {
      const Symbol& named = scope_.tree().symbols[symbol];
      if (named.rank == 0) continue;
      for (std::uint32_t copy = 1; copy <= (named.per_particle ? rough_particles : 1); ++copy) {
        for (std::size_t k = 0; k < component_count(named); ++k)
          point[static_cast<Eigen::Index>(layout_.place(symbol, copy, k))] = between(-1.5, 1.5);
      }
    }
    return point;
  }

  /// Nothing where a value is missing.
  [[nodiscard]] std::optional<std::vector<Sides>> sides_of(const Equation& equation,
                                                           const Eigen::VectorXd& point) {
    std::vector<Sides> all;
    std::vector<std::uint32_t> particles(equation.particles.size(), 1);
    domain_.look_at(point);
    evaluator_.forget();
    do {
      for (std::size_t i = 0; i < particles.size(); ++i) evaluator_.bind(equation.particles[i], particles[i]);
      static_cast<void>(
          for_each_component(evaluator_, scope_.tree(), equation,
                             [&](const std::vector<std::uint8_t>&, const Sloped& left, const Sloped& right) {
                               all.push_back({left, right});
                               return !domain_.is_rejected();
                             }));
      if (domain_.is_rejected()) return std::nullopt;
    } while (next_tuple(particles, 1u, rough_particles));
    return all;
  }

  /// Of all equations that are assumed, and |n| = 1 of unit vectors.
  [[nodiscard]] std::optional<std::vector<Sides>> equations_at(const Eigen::VectorXd& point) {
    std::vector<Sides> all;
    for (const std::size_t position : assumptions_) {
      const Equation& equation = scope_.question().assumptions[position];
      if (equation.relation != Relation::equal) continue;
      auto own = sides_of(equation, point);
      if (!own) return std::nullopt;
      std::ranges::move(*own, std::back_inserter(all));
    }
    domain_.look_at(point);
    for (const SymbolId symbol : symbols_) {
      const Symbol& named = scope_.tree().symbols[symbol];
      if (!named.unit) continue;
      for (std::uint32_t copy = 1; copy <= (named.per_particle ? rough_particles : 1); ++copy) {
        Sloped square;
        for (std::size_t k = 0; k < component_count(named); ++k)
          domain_.add(square, domain_.power(domain_.value(symbol, copy, k), 2));
        all.push_back({std::move(square), domain_.integer(1)});
      }
    }
    return all;
  }

  [[nodiscard]] bool move_onto_equations(Eigen::VectorXd& point) {
    for (int k = 0; k < most_corrections; ++k) {
      const auto equations = equations_at(point);
      if (!equations || equations->size() > most_rough_equations) return false;
      if (std::ranges::all_of(*equations, &Sides::agree)) return true;
      const Eigen::VectorXd step = step_onto(*equations, point);
      const double size = step.norm();
      const double most = largest_step * std::sqrt(static_cast<double>(point.size()));
      if (!std::isfinite(size)) return false;
      point -= size > most ? Eigen::VectorXd(step * (most / size)) : step;
    }
    return false;
  }

  /// The least one that takes away all differences, as far as slopes tell; to be subtracted.
  [[nodiscard]] static Eigen::VectorXd step_onto(const std::vector<Sides>& equations,
                                                 const Eigen::VectorXd& point) {
    const auto rows = static_cast<Eigen::Index>(equations.size());
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(rows, point.size());
    Eigen::VectorXd differences(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const Sides& own = equations[static_cast<std::size_t>(row)];
      differences[row] = own.difference();
      const Slope slope = sum_of(1, own.left.slope, -1, own.right.slope);
      if (slope.size() > 0) slopes.row(row) = slope.transpose();
    }
    return slopes.completeOrthogonalDecomposition().solve(differences);
  }

  /// Not nearly: a point where a divisor almost vanishes tells nothing.
  [[nodiscard]] bool keeps_orders(const Eigen::VectorXd& point) {
    return std::ranges::all_of(assumptions_, [&](std::size_t position) {
      const Equation& equation = scope_.question().assumptions[position];
      if (equation.relation == Relation::equal) return true;
      const auto sides = sides_of(equation, point);
      if (!sides) return false;
      if (equation.relation == Relation::unequal) return std::ranges::any_of(*sides, &Sides::differ);
      return std::ranges::all_of(*sides,
                                 [](const Sides& each) { return each.difference() < 0 && each.differ(); });
    });
  }

  const Scope& scope_;
  const std::vector<SymbolId>& symbols_;
  const std::vector<std::size_t>& assumptions_;
  Layout layout_;
  SlopedDomain domain_;
  Evaluator<SlopedDomain> evaluator_;
  SplitMix random_{0x5269676f72};
};

[[nodiscard]] bool fails_at_real_points(const Question& question, Budget* budget) {
  const Scope scope(question, Scope::Definitions::unfolded);
  const std::vector<std::size_t> assumptions = relevant_assumptions(scope);
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const std::size_t position : assumptions) {
    const Equation& each = question.assumptions[position];
    roots.insert(roots.end(), {each.left, each.right});
  }
  const Reach reached = reach(scope, roots);
  const auto turns = [&](SymbolId symbol) { return scope.tree().symbols[symbol].rotation; };
  if (reached.too_large || std::ranges::any_of(reached.symbols, turns)) return false;
  return RoughScreen(scope, reached, assumptions, budget).fails();
}

}  // namespace

bool fails_at_rough_points(const Question& question, Budget* budget) {
  if (question.claim.relation != Relation::equal || is_about_operators(question)) return false;
  try {
    if (is_about_complex(question))
      return fails_at_real_points(in_real_parts(closed(question).question).question, budget);
    return fails_at_real_points(question, budget);
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace rigor
