// SPDX-License-Identifier: GPL-3.0-or-later
// From a counterexample to the simplest one that is found: the part of Refuter that makes a sample fit for a
// blackboard.
#include <algorithm>
#include <array>
#include <utility>

#include "algebra/sample/refute.h"

namespace rigor {
namespace {

constexpr std::uint32_t tiny_attempts = 24;  // for each kind of point and number of particles
constexpr std::uint32_t few = 3;             // numbers that are not 0: hardly any simpler
constexpr int passes = 3;                    // over all numbers of a point
constexpr std::uint64_t least_shrink_steps = 30'000;
constexpr std::uint64_t most_shrink_steps = 500'000;
constexpr std::uint64_t cheap_look = 2'000;  // steps
constexpr std::uint64_t looks_worth = 34;    // so many times what one look costs, between these
constexpr std::uint64_t tiny_seed = 0x74696e79;

constexpr std::array small_numbers{0, 1, 2, -1, 3, -2, 4, -3, 5, -4};

/// The components of a vector or tensor where the axes of the common space are renumbered.
[[nodiscard]] std::vector<Rational> with_axes(std::span<const Rational> components, const Symbol& symbol,
                                              const std::array<std::size_t, 3>& order) {
  std::vector<Rational> result(components.size());
  for (std::size_t from = 0; from < components.size(); ++from) {
    std::size_t to = 0;
    std::size_t scale = 1;
    std::size_t rest = from;
    for (int k = symbol.rank - 1; k >= 0; --k) {
      const Space space = symbol.axes[k];
      const std::size_t axis = rest % space.dimension;
      to += scale * (space == common_space ? order[axis] : axis);
      rest /= space.dimension;
      scale *= space.dimension;
    }
    result[to] = components[from];
  }
  return result;
}

}  // namespace

bool Refuter::may_shrink() const { return evaluator_.steps() < shrinks_until_; }

void Refuter::consider(Counterexample& best, const SamplePoint& drawn, std::uint32_t attempt) {
  const Complexity below = complexity(best.point);
  auto found = fails_on(drawn, attempt, &below);
  if (!found) return;
  best = *std::move(found);
  best.drawn = best.point;  // what is changed next is changed in a point that meets the assumptions
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

/// Whole symbols 0, those first that only the assumptions speak of.
void Refuter::clear_symbols(Counterexample& best) {
  for (auto symbol = reach_.symbols.rbegin(); symbol != reach_.symbols.rend() && may_shrink(); ++symbol) {
    SamplePoint cleared = best.drawn;
    bool any = false;
    for (const Coordinate& at : cleared.coordinates_of(*symbol)) {
      if (!cleared.is_free(at) || cln::zerop(cleared[at])) continue;
      cleared.set(at, 0);
      any = true;
    }
    if (any) consider(best, cleared, best.attempt);
  }
}

/// Earlier axes before later ones, and earlier particles: the same sample with its axes or its particles
/// renumbered.
void Refuter::exchange_axes(Counterexample& best) {
  constexpr std::array<std::array<std::size_t, 3>, 5> orders{
      {{1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};
  const ExprTree& tree = scope_->tree();
  const SamplePoint before = best.drawn;
  for (const auto& order : orders) {
    SamplePoint renumbered = before;
    for (const SymbolId symbol : reach_.symbols) {
      const bool each = tree.symbols[symbol].per_particle;
      for (std::uint32_t p = each ? 1 : 0; p <= (each ? before.particles() : 0); ++p)
        renumbered.set_all(symbol, p, with_axes(before.values(symbol, p), tree.symbols[symbol], order));
    }
    if (may_shrink()) consider(best, renumbered, best.attempt);
  }
  for (std::uint32_t p = 2; p <= best.drawn.particles() && may_shrink(); ++p)
    consider(best, best.drawn.with_exchanged(p - 1, p), best.attempt);
}

/// Angles and logarithms themselves, not multiples of them.
void Refuter::take_multiples_away(Counterexample& best) {
  SamplePoint plain = best.drawn;
  bool any = false;
  for (const SymbolId symbol : reach_.symbols) {
    Meaning meaning = plain.meaning(symbol);
    if (meaning.multiple == 1) continue;
    meaning.multiple = 1;
    plain.mean(symbol, meaning);
    for (const Coordinate& at : plain.coordinates_of(symbol)) plain.set(at, 1);
    any = true;
  }
  if (any) consider(best, plain, best.attempt);
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

/// All of the claim's scalars 1, or all but one, which is 2: no single one need be simpler on the way there.
void Refuter::make_scalars_alike(Counterexample& best) {
  std::vector<Coordinate> scalars;
  for (const SymbolId symbol : claim_symbols_) {
    const Symbol& named = scope_->tree().symbols[symbol];
    if (named.rank == 0 && !named.per_particle && best.drawn.is_free({symbol})) scalars.push_back({symbol});
  }
  if (scalars.size() < 2) return;
  SamplePoint alike = best.drawn;
  for (const Coordinate& at : scalars) alike.set(at, 1);
  consider(best, alike, best.attempt);
  for (const Coordinate& at : scalars) {
    if (!may_shrink()) return;
    SamplePoint changed = alike;
    changed.set(at, 2);
    consider(best, changed, best.attempt);
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

/// One thing after the other made smaller in the best sample so far.
void Refuter::descend(Counterexample& best) {
  drop_particles(best);
  take_multiples_away(best);
  clear_symbols(best);
  make_particles_alike(best);
  make_scalars_alike(best);
  for (int pass = 0; pass < passes && make_smaller(best); ++pass) {
  }
  exchange_axes(best);
}

/// Descents and enumerations, as what a look costs allows. Where nothing is assumed, a descent tells how far
/// to enumerate. To meet differential equations may cost a thousand times more, the less the more numbers
/// are 0.
void Refuter::shrink(Counterexample& best, std::uint64_t one_look) {
  const std::uint64_t budget = std::clamp(looks_worth * one_look, least_shrink_steps, most_shrink_steps);
  evaluator_.allow_more(4 * budget);
  const auto with_budget = [&](const auto& part) {
    shrinks_until_ = evaluator_.steps() + budget;
    part();
  };
  const bool is_costly = one_look > cheap_look;
  if (is_costly && best.point.particles() == 0) with_budget([&] { look_among_few(best); });
  if (!is_costly && !solver_.none()) with_budget([&] { look_among_tiny_points(best); });
  with_budget([&] { descend(best); });
  if (is_costly || complexity(best.point).nonzero <= (solver_.none() ? 1 : few)) return;
  const Complexity before = complexity(best.point);
  with_budget([&] { look_among_few(best); });
  if (solver_.none() && complexity(best.point).nonzero > few) look_among_tiny_points(best);
  if (complexity(best.point) < before) with_budget([&] { descend(best); });
}

Sample Refuter::simplest(const Counterexample& found) {
  Counterexample best = found;
  best.drawn = best.point;
  try {
    const std::uint64_t start = evaluator_.steps();
    static_cast<void>(fails_on(found.drawn, found.attempt));
    shrink(best, evaluator_.steps() - start);
  } catch (const Undecidable&) {
    // too much work: the best so far will do
  }
  return to_sample(best);
}

}  // namespace rigor
