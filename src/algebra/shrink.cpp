// SPDX-License-Identifier: GPL-3.0-or-later
// From a counterexample to the simplest one that is found: the part of Refuter that makes a sample fit for a
// blackboard.
#include <algorithm>
#include <array>
#include <utility>

#include "algebra/refute.h"
#include "algebra/sample_rotation.h"

namespace rigor {
namespace {

constexpr std::uint32_t tiny_attempts = 24;  // for each kind of point and number of particles
constexpr int passes = 3;                    // over all numbers of a point
constexpr std::uint64_t shrink_steps = 30'000;
constexpr std::uint64_t tiny_seed = 0x74696e79;

constexpr std::array small_numbers{0, 1, 2, -1, 3, -2, 4, -3, 5, -4};

/// The unit vectors along the axes, or the rotations that a reader knows.
[[nodiscard]] std::vector<std::vector<Rational>> simple_wholes(const Symbol& symbol) {
  std::vector<std::vector<Rational>> all;
  if (symbol.rotation) {
    for (const RotationMatrix& each : known_rotations()) all.emplace_back(each.begin(), each.end());
    return all;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all.emplace_back(3, Rational(0));
    all.back()[axis] = 1;
  }
  return all;
}

}  // namespace

bool Refuter::may_shrink() const { return evaluator_.steps() < shrinks_until_; }

void Refuter::consider(Counterexample& best, const SamplePoint& drawn, std::uint32_t attempt) {
  const Complexity below = complexity(best.point);
  if (auto found = fails_on(drawn, attempt, &below)) best = *std::move(found);
}

void Refuter::look_among_tiny_points(Counterexample& best) {
  SplitMix random(tiny_seed);
  const std::uint32_t most = best.point.particles();
  for (std::uint32_t particles = std::min(most, 1u); particles <= std::min(most, 3u); ++particles) {
    const Complexity before = complexity(best.point);
    for (const Draw from : {Draw::zero_or_one, Draw::tiny, Draw::along_axes, Draw::with_lengths}) {
      if ((from == Draw::along_axes || from == Draw::with_lengths) && !reach_.roots) continue;
      for (std::uint32_t attempt = 0; attempt < tiny_attempts && may_shrink(); ++attempt) {
        SamplePoint point(scope_->tree(), reach_.symbols, particles);
        point.mean_as(best.drawn);
        draw(point, scope_->tree(), from, random);
        consider(best, point, attempt);
      }
      if (complexity(best.point) < before) return;
    }
  }
}

void Refuter::drop_particles(Counterexample& best) {
  for (std::uint32_t particle = best.drawn.particles(); particle > 0; --particle) {
    if (best.drawn.particles() > 1) consider(best, best.drawn.without_particle(particle), best.attempt);
  }
}

/// All particles' masses 1, and the like.
void Refuter::make_particles_alike(Counterexample& best) {
  for (const SymbolId symbol : reach_.symbols) {
    const Symbol& named = scope_->tree().symbols[symbol];
    if (!named.per_particle || named.rank != 0) continue;
    SamplePoint alike = best.drawn;
    for (const Coordinate& at : alike.coordinates_of(symbol)) {
      if (alike.is_free(at)) alike.set(at, 1);
    }
    consider(best, alike, best.attempt);
  }
}

/// One pass over the numbers of the point; true if one became smaller.
bool Refuter::make_smaller(Counterexample& best) {
  bool any = false;
  for (const Coordinate& at : best.drawn.coordinates()) {
    const Complexity before = complexity(best.point);
    const bool whole = best.drawn.is_whole(at);
    const std::vector<std::vector<Rational>> wholes =
        whole ? simple_wholes(scope_->tree().symbols[at.symbol]) : std::vector<std::vector<Rational>>{};
    const std::size_t choices = whole ? wholes.size() : small_numbers.size();
    for (std::size_t choice = 0; choice < choices && !(complexity(best.point) < before) && may_shrink();
         ++choice) {
      SamplePoint changed = best.drawn;
      if (whole) {
        changed.set_all(at.symbol, at.particle, wholes[choice]);
      } else if (changed[at] == small_numbers[choice]) {
        break;  // what follows is no simpler
      } else {
        changed.set(at, small_numbers[choice]);
      }
      consider(best, changed, best.attempt);
    }
    any = any || complexity(best.point) < before;
  }
  return any;
}

Sample Refuter::simplest(const Counterexample& found) {
  Counterexample best = found;
  shrinks_until_ = evaluator_.steps() + shrink_steps;
  try {
    look_among_tiny_points(best);
    drop_particles(best);
    make_particles_alike(best);
    for (int pass = 0; pass < passes && make_smaller(best); ++pass) {
    }
  } catch (const Undecidable&) {
    // too much work: the best so far will do
  }
  return to_sample(best);
}

}  // namespace rigor
