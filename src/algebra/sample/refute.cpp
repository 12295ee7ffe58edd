// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/refute.h"

#include <algorithm>

#include "algebra/sample/sample_text.h"

namespace rigor {
namespace {

constexpr std::uint32_t quick_attempts = 24;
constexpr std::uint32_t free_attempts = 8;
constexpr std::uint32_t enclosed_attempts = 16;
constexpr std::uint32_t enough_points = 4;
constexpr std::size_t most_zero_alone = 8;  // symbols

}  // namespace

/// Two points are the same where all numbers are, and mean the same.
[[nodiscard]] std::string text_of(const SamplePoint& point) {
  std::string text;
  for (const SymbolId symbol : point.symbols()) {
    const Meaning& meaning = point.meaning(symbol);
    for (const Coordinate& at : point.coordinates_of(symbol)) {
      if (!point.is_whole(at)) {
        text += to_text(point[at], meaning) + ' ';
        continue;
      }
      for (const Rational& each : point.values(symbol, at.particle)) text += to_text(each) + ' ';
    }
  }
  return text + std::to_string(point.particles());
}

Reach reach_of_sample(const Scope& scope, const std::vector<std::size_t>& assumptions) {
  std::vector<ExprId> roots{scope.question().claim.left, scope.question().claim.right};
  for (const std::size_t position : assumptions) {
    roots.push_back(scope.question().assumptions[position].left);
    roots.push_back(scope.question().assumptions[position].right);
  }
  return reach(scope, roots);
}

Refuter::Refuter(const Scope& scope, const Limits& limits)
    : scope_(&scope),
      limits_(limits),
      solver_(scope, relevant_assumptions(scope)),
      reach_(reach_of_sample(scope, solver_.assumptions())),
      evaluator_(scope, limits),
      sequence_(scope.tree(), reach_, solver_.has_particle_sums()),
      claim_symbols_(rigor::reach(scope, scope.question().claim).symbols) {}

std::optional<Refuter::Counterexample> Refuter::fails_on(const SamplePoint& drawn, std::uint32_t attempt,
                                                         const Complexity* below) {
  point_ = drawn;
  SamplePoint& point = *point_;
  try {
    if (!solver_.none() && !solver_.solve(evaluator_, point, attempt)) return std::nullopt;
    if (below != nullptr && !(complexity(point) < *below)) return std::nullopt;
    evaluator_.look_at(point);
    std::optional<Difference> difference = evaluator_.difference(scope_->question().claim);
    if (below == nullptr && compared_.insert(text_of(point)).second) ++points_compared_;
    if (!difference) return std::nullopt;
    return Counterexample{drawn, point, attempt, *std::move(difference)};
  } catch (const ValuesTooNear&) {
    has_near_values_ = true;
    return std::nullopt;
  } catch (const PointRejected&) {
    return std::nullopt;
  }
}

std::optional<Refuter::Counterexample> Refuter::attempt_next() {
  const std::uint32_t attempt = sequence_.drawn();
  return fails_on(sequence_.next(), attempt);
}

std::optional<Refuter::Counterexample> Refuter::quick_look() {
  const std::uint32_t wanted = is_constant() ? 1 : limits_.quick_points;
  if (is_constant()) evaluator_.enclose();
  while (points_compared_ < wanted && sequence_.drawn() < quick_attempts &&
         evaluator_.steps() < limits_.quick_steps) {
    if (auto found = attempt_next()) return found;
  }
  return std::nullopt;
}

bool Refuter::fails_without_assumptions() {
  SampleSequence points(scope_->tree(), reach_, false);
  for (std::uint32_t attempt = 0; attempt < free_attempts; ++attempt) {
    point_ = points.next();
    try {
      evaluator_.look_at(*point_);
      if (evaluator_.difference(scope_->question().claim)) return true;
    } catch (const PointRejected&) {
      // the next one
    } catch (const Undecidable&) {
      return false;
    }
  }
  return false;
}

/// Where strict orders fail: all numbers 0, or all but the scalars, which are 1; or those of one symbol.
std::optional<Refuter::Counterexample> Refuter::look_at_zero() {
  SplitMix random(0);
  const auto look = [&](const SamplePoint& point) {
    ++looked_at_zero_;
    return fails_on(point, 0);
  };
  for (const int scalar : {1, 0}) {
    SamplePoint point(scope_->tree(), reach_.symbols, reach_.particles ? 1 : 0);
    draw(point, scope_->tree(), Draw::tiny, random);
    for (const Coordinate& at : point.coordinates()) {
      if (!point.is_whole(at)) point.set(at, scope_->tree().symbols[at.symbol].rank == 0 ? scalar : 0);
    }
    if (auto found = look(point)) return found;
  }
  const std::size_t alone = std::min(reach_.symbols.size(), most_zero_alone);
  for (std::size_t i = 0; i < alone && alone > 1; ++i) {
    for (const Draw from : {Draw::tiny, Draw::along_axes}) {
      SamplePoint point(scope_->tree(), reach_.symbols, reach_.particles ? 1 : 0);
      draw(point, scope_->tree(), from, random);
      for (const Coordinate& at : point.coordinates_of(reach_.symbols[i])) {
        if (!point.is_whole(at)) point.set(at, 0);
      }
      if (auto found = look(point)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Refuter::Counterexample> Refuter::search() {
  if (scope_->question().claim.relation != Relation::equal) {
    if (auto found = look_at_zero()) return found;
  }
  while (sequence_.drawn() < limits_.sample_attempts) {
    if (auto found = attempt_next()) return found;
  }
  // Where few points have rational values, these are special: `\ln(a/b)` has one where a = b.
  const bool special = points_compared_ < enough_points || 2 * points_compared_ < sequence_.drawn();
  return special ? search_enclosed() : std::nullopt;
}

/// From now on everything is enclosed: what is found is made simple, too.
std::optional<Refuter::Counterexample> Refuter::search_enclosed() {
  evaluator_.enclose();
  const std::uint32_t most = sequence_.drawn() + std::min(limits_.sample_attempts, enclosed_attempts);
  while (sequence_.drawn() < most) {
    const std::uint32_t attempt = sequence_.drawn();
    const SamplePoint point = sequence_.next();
    if (auto found = fails_on(attempt % 2 == 0 ? point : made_small(point), attempt)) return found;
  }
  return std::nullopt;
}

bool Refuter::finds_a_point() {
  const auto found = [&] { return points_compared_ > 0 || has_near_values_; };
  const auto look = [&](std::uint32_t until) {
    while (!found() && sequence_.drawn() < until) static_cast<void>(attempt_next());
  };
  evaluator_.take_circle_number_as_rational();
  look(std::max(limits_.sample_attempts, sequence_.drawn() + quick_attempts));
  evaluator_.enclose();
  for (std::uint32_t k = 0; k < enclosed_attempts && !found(); ++k)
    static_cast<void>(fails_on(k % 2 == 0 ? sequence_.next() : made_small(sequence_.next()), k));
  evaluator_.take_circle_number_as_it_is();
  return found();
}

Sample Refuter::to_sample(const Counterexample& found) const {
  Sample sample;
  sample.particles = found.point.particles();
  sample.values = values_of(found.point, scope_->tree());
  sample.axes = found.difference.place.axes;
  sample.free_particles = found.difference.place.particles;
  sample.left = to_text(found.difference.left);
  sample.right = to_text(found.difference.right);
  return sample;
}

}  // namespace rigor
