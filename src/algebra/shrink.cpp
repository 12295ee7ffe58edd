// SPDX-License-Identifier: GPL-3.0-or-later
// From a counterexample to the simplest one that is found: the part of Refuter that makes a sample fit for a
// blackboard.
#include <algorithm>
#include <array>
#include <utility>

#include "algebra/refute.h"

namespace rigor {
namespace {

constexpr std::uint32_t tiny_attempts = 24;  // for each kind of point and number of particles
constexpr int passes = 3;                    // over all numbers of a point
constexpr std::uint64_t tiny_seed = 0x74696e79;

constexpr std::array small_numbers{0, 1, 2, -1, 3, -2, 4, -3, 5, -4};

}  // namespace

void Refuter::consider(Counterexample& best, const SamplePoint& drawn, std::uint32_t attempt) {
  std::optional<Counterexample> found = fails_on(drawn, attempt);
  if (found && complexity(found->point) < complexity(best.point)) best = *std::move(found);
}

void Refuter::look_among_tiny_points(Counterexample& best) {
  SplitMix random(tiny_seed);
  const std::uint32_t most = best.point.particles();
  for (std::uint32_t particles = std::min(most, 1u); particles <= std::min(most, 3u); ++particles) {
    const Complexity before = complexity(best.point);
    for (const Draw from : {Draw::zero_or_one, Draw::tiny, Draw::along_axes, Draw::with_lengths}) {
      if ((from == Draw::along_axes || from == Draw::with_lengths) && !reach_.roots) continue;
      for (std::uint32_t attempt = 0; attempt < tiny_attempts; ++attempt) {
        SamplePoint point(scope_->tree(), reach_.symbols, particles);
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

/// One pass over the numbers of the point; true if one became smaller.
bool Refuter::make_smaller(Counterexample& best) {
  bool any = false;
  for (const Coordinate& at : best.drawn.coordinates()) {
    const Complexity before = complexity(best.point);
    const std::size_t choices = best.drawn.is_direction(at) ? 3 : small_numbers.size();
    for (std::size_t choice = 0; choice < choices && !(complexity(best.point) < before); ++choice) {
      SamplePoint changed = best.drawn;
      if (changed.is_direction(at)) {
        std::array<Rational, 3> unit{0, 0, 0};
        unit[choice] = 1;
        changed.set_all(at.symbol, at.particle, unit);
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
  try {
    look_among_tiny_points(best);
    drop_particles(best);
    for (int pass = 0; pass < passes && make_smaller(best); ++pass) {
    }
  } catch (const Undecidable&) {
    // too much work: the best so far will do
  }
  return to_sample(best);
}

}  // namespace rigor
