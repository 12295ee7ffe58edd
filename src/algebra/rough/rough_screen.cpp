// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/rough/rough_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "algebra/evaluator/components.h"
#include "algebra/evaluator/evaluator.h"
#include "algebra/parts/real_parts.h"
#include "algebra/rough/rough_program.h"
#include "algebra/words/operator_question.h"
#include "base/splitmix.h"
#include "expr/statement/closed_question.h"

namespace rigor {
namespace {

constexpr int most_numbers = 128;
constexpr std::size_t most_rough_equations = 160;
constexpr std::uint64_t most_steps = 20'000;  // of evaluation, to write the program
constexpr std::uint64_t most_work = 10'000;   // units, for the points of one choice of assumptions
constexpr std::uint64_t run_in_a_unit = 512;  // instructions, times the numbers of a point
constexpr std::uint64_t solved_in_a_unit = 150;
constexpr int most_draws = 24;  // most do not keep the orders, if there are several
constexpr int most_lost = 4;    // that do not come onto the equations
constexpr int wanted_rough_points = 2;
constexpr int most_corrections = 40;  // a double root takes one for each bit
constexpr double holds_within = 1e-12;
constexpr double differs_by = 1e-4;  // relative to the sides, and absolute: numbers are drawn near 1
constexpr double largest_step = 2;
constexpr double clear_step = 1e-3;  // a point that is nearer to where the claim holds tells nothing

}  // namespace

class RoughScreen::Points {
  /// The sides of an equation in one component, for one choice of particles.
  struct Sides {
    RoughValue left;
    RoughValue right;
  };
  /// The same at a point.
  struct SideNumbers {
    double left;
    double right;
    [[nodiscard]] double difference() const { return left - right; }
    [[nodiscard]] double size() const { return std::abs(left) + std::abs(right); }
    [[nodiscard]] bool agree() const { return std::abs(difference()) <= holds_within * (1 + size()); }
    [[nodiscard]] bool differ() const {
      return std::abs(difference()) > differs_by * size() && std::abs(difference()) > differs_by;
    }
  };
  /// An equation in all its components, and the part of the program that calculates it.
  struct Written {
    Relation relation = Relation::equal;
    std::vector<Sides> sides = {};
    std::size_t end = 0;  // of the program so far
  };

 public:
  Points(const Scope& scope, std::vector<SymbolId> symbols, std::vector<std::size_t> assumptions,
         Budget* budget)
      : scope_(scope),
        symbols_(std::move(symbols)),
        layout_(scope.tree(), symbols_),
        program_(layout_.size()),
        domain_(program_, layout_, most_steps),
        evaluator_(scope, domain_),
        budget_(budget) {
    if (layout_.size() == 0 || layout_.size() > static_cast<std::size_t>(most_numbers))
      throw Undecidable("it has too many numbers");
    const auto& question = scope_.question();
    for (const bool equations : {true, false}) {
      for (const std::size_t position : assumptions) {
        const Equation& each = question.assumptions[position];
        if ((each.relation == Relation::equal) == equations) written_.emplace(position, written(each));
      }
      if (equations) write_lengths();
    }
    claim_ = written(question.claim);
  }

  [[nodiscard]] bool has_values_under(std::span<const std::size_t> assumptions) {
    begin(assumptions);
    for (int draw = 0; draw < most_draws; ++draw) {
      Eigen::VectorXd point = drawn(draw);
      if (!move_onto_equations(point) || !keeps_orders(point)) continue;
      program_.look_at(point);
      if (run(claim_) && is_settled(point)) return true;
    }
    return false;
  }

  [[nodiscard]] bool fails_under(std::span<const std::size_t> assumptions) {
    begin(assumptions);
    int points = 0;
    int lost = 0;
    for (int draw = 0; draw < most_draws && lost < most_lost && points < wanted_points(); ++draw) {
      Eigen::VectorXd point = drawn(draw);
      if (!move_onto_equations(point)) {
        ++lost;
        continue;
      }
      if (!keeps_orders(point)) continue;
      program_.look_at(point);
      const auto differences = all_sides(equations_);
      if (!differences || !run(claim_)) continue;
      if (!is_broken()) {
        if (claim_.relation == Relation::equal) return false;
        continue;  // elsewhere it may be
      }
      // Where a divisor of the claim has become 0, the least step would do: `\mu \to 0` of 1/\mu.
      std::vector<Sides> all = *differences;
      all.insert(all.end(), claim_.sides.begin(), claim_.sides.end());
      if (!(step_onto(all).norm() >= clear_step)) continue;
      ++points;
    }
    return points == wanted_points();
  }

 private:
  void begin(std::span<const std::size_t> assumptions) {
    equations_.clear();
    orders_.clear();
    for (const std::size_t position : assumptions) {
      const Written& each = written_.at(position);
      (each.relation == Relation::equal ? equations_ : orders_).push_back(&each);
    }
    equations_.push_back(&lengths_);
    random_ = SplitMix(seed);
    work_ = 0;
  }

  // --- writing the program

  [[nodiscard]] Written written(const Equation& equation) {
    const std::uint64_t before = domain_.steps();
    Written made{.relation = equation.relation};
    std::vector<std::uint32_t> particles(equation.particles.size(), 1);
    do {
      for (std::size_t i = 0; i < particles.size(); ++i) evaluator_.bind(equation.particles[i], particles[i]);
      static_cast<void>(
          for_each_component(evaluator_, scope_.tree(), equation,
                             [&](const std::vector<std::uint8_t>&, RoughValue left, RoughValue right) {
                               made.sides.push_back({left, right});
                               return true;
                             }));
    } while (next_tuple(particles, 1u, rough_particles));
    made.end = program_.size();
    if (budget_ != nullptr) budget_->count(domain_.steps() - before);
    return made;
  }

  /// |n| = 1 of unit vectors.
  void write_lengths() {
    for (const SymbolId symbol : symbols_) {
      const Symbol& named = scope_.tree().symbols[symbol];
      if (!named.unit) continue;
      for (std::uint32_t copy = 1; copy <= (named.per_particle ? rough_particles : 1); ++copy) {
        RoughValue square;
        for (std::size_t k = 0; k < component_count(named); ++k)
          domain_.add(square, domain_.power(domain_.value(symbol, copy, k), 2));
        lengths_.sides.push_back({square, domain_.integer(1)});
      }
    }
    lengths_.end = program_.size();
  }

  // --- running it

  /// An equation that follows from nothing fails nearly everywhere; an order need not, and one point is
  /// enough.
  [[nodiscard]] int wanted_points() const {
    return claim_.relation == Relation::equal ? wanted_rough_points : 1;
  }
  [[nodiscard]] bool is_broken() const {
    return std::ranges::any_of(claim_.sides, [&](const Sides& each) {
      const SideNumbers at = at_point(each);
      return at.differ() && (claim_.relation == Relation::equal || at.difference() > 0);
    });
  }
  /// False where a value is missing.
  [[nodiscard]] bool run(const Written& equation) {
    count(program_.to_be_run(equation.end) * (8 + layout_.size()) / run_in_a_unit);
    return program_.run_to(equation.end);
  }
  void count(std::uint64_t units) {
    if (budget_ != nullptr) budget_->count(units);
    if ((work_ += units) > most_work) throw Undecidable("no rough point was found in time");
  }
  [[nodiscard]] SideNumbers at_point(const Sides& sides) const {
    return {program_.value(sides.left), program_.value(sides.right)};
  }
  [[nodiscard]] std::optional<std::vector<Sides>> all_sides(const std::vector<const Written*>& equations) {
    std::vector<Sides> all;
    for (const Written* each : equations) {
      if (!run(*each)) return std::nullopt;
      all.insert(all.end(), each->sides.begin(), each->sides.end());
    }
    return all;
  }

  /// Positive scalars first, and in every other draw: most quantities are.
  [[nodiscard]] Eigen::VectorXd drawn(int draw) {
    Eigen::VectorXd point(static_cast<Eigen::Index>(layout_.size()));
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random_.next() >> 11U) * 0x1p-53;
    };
    for (double& each : point)
      each = between(0.3, 1.9) * (draw > 1 && draw % 2 == 1 && random_.below(2) == 0 ? -1 : 1);
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

  [[nodiscard]] bool move_onto_equations(Eigen::VectorXd& point) {
    for (int k = 0; k < most_corrections; ++k) {
      program_.look_at(point);
      const auto equations = all_sides(equations_);
      if (!equations || equations->size() > most_rough_equations) return false;
      if (std::ranges::all_of(*equations, [&](const Sides& each) { return at_point(each).agree(); }))
        return true;
      const Eigen::VectorXd step = step_onto(*equations);
      const double size = step.norm();
      const double most = largest_step * std::sqrt(static_cast<double>(point.size()));
      if (!std::isfinite(size)) return false;
      point -= size > most ? Eigen::VectorXd(step * (most / size)) : step;
    }
    return false;
  }

  /// A little step is left, as at a simple root; none as `e^{-x} = 0` has far out, or `x^4 = 0` near 0.
  [[nodiscard]] bool is_settled(const Eigen::VectorXd& point) {
    constexpr double little = 1e-6;
    program_.look_at(point);
    const auto equations = all_sides(equations_);
    return equations && (equations->empty() || step_onto(*equations).norm() < little * (1 + point.norm()));
  }

  /// The least one that takes away all differences, as far as slopes tell; to be subtracted.
  [[nodiscard]] Eigen::VectorXd step_onto(const std::vector<Sides>& equations) {
    const std::size_t numbers = layout_.size();
    count(equations.size() * numbers * std::min(equations.size(), numbers) / solved_in_a_unit);
    const auto rows = static_cast<Eigen::Index>(equations.size());
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(numbers));
    Eigen::VectorXd differences(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const Sides& own = equations[static_cast<std::size_t>(row)];
      differences[row] = at_point(own).difference();
      program_.add_slope(own.left, 1, slopes.row(row));
      program_.add_slope(own.right, -1, slopes.row(row));
    }
    return slopes.completeOrthogonalDecomposition().solve(differences);
  }

  /// Not nearly: a point where a divisor almost vanishes tells nothing.
  [[nodiscard]] bool keeps_orders(const Eigen::VectorXd& point) {
    program_.look_at(point);
    return std::ranges::all_of(orders_, [&](const Written* order) {
      if (!run(*order)) return false;
      if (order->relation == Relation::unequal)
        return std::ranges::any_of(order->sides, [&](const Sides& each) { return at_point(each).differ(); });
      return std::ranges::all_of(order->sides, [&](const Sides& each) {
        const SideNumbers at = at_point(each);
        return at.difference() < 0 && at.differ();
      });
    });
  }

  static constexpr std::uint64_t seed = 0x5269676f72;

  const Scope& scope_;
  std::vector<SymbolId> symbols_;
  RoughLayout layout_;
  RoughProgram program_;
  RoughDomain domain_;
  Evaluator<RoughDomain> evaluator_;
  Budget* budget_;
  std::map<std::size_t, Written> written_;  // by position of the assumption
  Written lengths_;
  Written claim_;
  std::vector<const Written*> equations_;  // those that are looked at now
  std::vector<const Written*> orders_;
  SplitMix random_{seed};
  std::uint64_t work_ = 0;
};

RoughScreen::RoughScreen(const Scope& scope, std::vector<std::size_t> assumptions, Budget* budget) {
  const Question& question = scope.question();
  if (question.claim.relation == Relation::unequal) return;
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const std::size_t position : assumptions) {
    const Equation& each = question.assumptions[position];
    roots.insert(roots.end(), {each.left, each.right});
  }
  Reach reached = reach(scope, roots);
  const auto turns = [&](SymbolId symbol) { return scope.tree().symbols[symbol].rotation; };
  if (reached.too_large || std::ranges::any_of(reached.symbols, turns)) return;
  try {
    points_ = std::make_unique<Points>(scope, std::move(reached.symbols), std::move(assumptions), budget);
  } catch (const Undecidable&) {
    // it is too large
  }
}

RoughScreen::~RoughScreen() = default;

bool RoughScreen::fails_under(std::span<const std::size_t> assumptions) {
  try {
    return points_ != nullptr && points_->fails_under(assumptions);
  } catch (const Undecidable&) {
    return false;
  }
}

bool RoughScreen::has_values_under(std::span<const std::size_t> assumptions) {
  try {
    return points_ != nullptr && points_->has_values_under(assumptions);
  } catch (const Undecidable&) {
    return false;
  }
}

namespace {

/// What is asked of the points under all assumptions that matter.
using AskedOfPoints = bool (RoughScreen::*)(std::span<const std::size_t>);

[[nodiscard]] bool at_real_points(const Question& question, Budget* budget, AskedOfPoints asked) {
  const Scope scope(question, Scope::Definitions::unfolded);
  const std::vector<std::size_t> assumptions = relevant_assumptions(scope);
  RoughScreen screen(scope, assumptions, budget);
  return (screen.*asked)(assumptions);
}

[[nodiscard]] bool at_points(const Question& question, Budget* budget, AskedOfPoints asked) {
  if (question.claim.relation == Relation::unequal || is_about_operators(question)) return false;
  try {
    if (is_about_complex(question))
      return at_real_points(in_real_parts(closed(question).question).question, budget, asked);
    return at_real_points(question, budget, asked);
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace

bool fails_at_rough_points(const Question& question, Budget* budget) {
  return at_points(question, budget, &RoughScreen::fails_under);
}

bool is_met_at_rough_points(const Question& question, Budget* budget) {
  return at_points(question, budget, &RoughScreen::has_values_under);
}

}  // namespace rigor
