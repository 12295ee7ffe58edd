// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "algebra/sample/sample_point.h"
#include "algebra/sample/sample_rotation.h"

namespace rigor {
namespace {

using Whole3 = std::array<int, 3>;

// Vectors of rational length; sums and differences of the first nine often have one too.
constexpr std::array<Whole3, 16> rational_lengths{{{3, 0, 0},
                                                   {0, 4, 0},
                                                   {3, 4, 0},
                                                   {0, 0, 12},
                                                   {1, 0, 0},
                                                   {0, 1, 0},
                                                   {0, 0, 1},
                                                   {-3, 0, 0},
                                                   {0, -4, 0},
                                                   {1, 2, 2},
                                                   {2, -1, 2},
                                                   {2, 3, 6},
                                                   {6, -2, 3},
                                                   {-1, 4, 8},
                                                   {4, 4, 7},
                                                   {2, 6, -9}}};

constexpr std::array squares_and_legs{1, 4, 9, 3, 12, 5, -1, -3, -4, 16, 2, 0};
constexpr std::array generic_numbers{1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6, 7, -7, 8, -8, 9, -9, 0};

[[nodiscard]] Rational draw_number(Draw from, int rank, SplitMix& random) {
  switch (from) {
    case Draw::zero_or_one:
      return rank == 0 ? static_cast<int>(random.below(3)) + 1 : static_cast<int>(random.below(2));
    case Draw::tiny:
      return rank == 0 ? static_cast<int>(random.below(3)) + 1 : static_cast<int>(random.below(4)) - 1;
    case Draw::generic:
    case Draw::balanced:
    case Draw::balanced_out:
      return random.pick<int>(generic_numbers);
    case Draw::along_axes:
    case Draw::with_lengths:
      return random.pick<int>(squares_and_legs);
    case Draw::directions:
      return random.below(2) == 0 ? 1 : -1;
  }
  return 0;
}

/// The tangent of half an angle, or a number whose logarithm is taken.
[[nodiscard]] Rational draw_seen_by_functions(Meaning::Kind kind, SplitMix& random) {
  const int above = static_cast<int>(random.below(3)) + 1;
  const int below = static_cast<int>(random.below(3)) + 1;
  const bool negative = kind == Meaning::Kind::angle && random.below(4) == 0;
  return Rational(negative ? -above : above) / below;
}

[[nodiscard]] Draw draw_for(std::uint32_t attempt, bool roots) {
  if (attempt % 8 == 7) return Draw::tiny;
  if (attempt % 8 == 3) return roots ? Draw::along_axes : Draw::directions;
  if (attempt % 16 == 5) return Draw::directions;
  return roots ? Draw::with_lengths : Draw::generic;
}

[[nodiscard]] std::uint32_t particles_for(std::uint32_t attempt) {
  constexpr std::array<std::uint32_t, 8> counts{2, 3, 2, 1, 4, 3, 5, 2};
  return counts[attempt % counts.size()];
}

[[nodiscard]] std::array<Rational, 3> axis_direction(SplitMix& random, bool negative_too) {
  std::array<Rational, 3> unit{0, 0, 0};
  unit[random.below(3)] = negative_too && random.below(2) == 0 ? -1 : 1;
  return unit;
}

/// (2p, 2q, 1 − p² − q²) / (1 + p² + q²): every rational direction but one, by stereographic projection.
[[nodiscard]] std::array<Rational, 3> draw_direction(Draw from, SplitMix& random) {
  if (from == Draw::zero_or_one || from == Draw::tiny) return axis_direction(random, from == Draw::tiny);
  if (random.below(4) == 0) return axis_direction(random, true);
  const Rational p =
      Rational(static_cast<int>(random.below(9)) - 4) / (static_cast<int>(random.below(3)) + 1);
  const Rational q =
      Rational(static_cast<int>(random.below(9)) - 4) / (static_cast<int>(random.below(3)) + 1);
  const Rational square = p * p + q * q;
  return {2 * p / (1 + square), 2 * q / (1 + square), (1 - square) / (1 + square)};
}

/// A vector of rational length: one of the list, its axes permuted, times a small factor.
[[nodiscard]] std::array<Rational, 3> draw_with_length(SplitMix& random) {
  const Whole3& from = random.pick<Whole3>(rational_lengths);
  const std::size_t turn = random.below(2) == 0 ? 0 : random.below(3);
  const int factor = random.below(3) == 0 ? -2 : 1;
  std::array<Rational, 3> vector;
  for (std::size_t i = 0; i < 3; ++i) vector[i] = factor * from[(i + turn) % 3];
  return vector;
}

[[nodiscard]] std::vector<Rational> draw_along_axis(std::uint32_t dimension, SplitMix& random) {
  constexpr std::array lengths{1, -1, 2, 3, -3, 4};
  std::vector<Rational> vector(dimension, 0);
  vector[random.below(dimension)] = random.pick<int>(lengths);
  return vector;
}

/// (2p, 1 − p²) / (1 + p²) for a vector p, times a small factor: a rational length in any dimension.
[[nodiscard]] std::vector<Rational> draw_projected(std::uint32_t dimension, SplitMix& random) {
  std::vector<Rational> vector;
  Rational square = 0;
  for (std::uint32_t k = 1; k < dimension; ++k) {
    const Rational p =
        Rational(static_cast<int>(random.below(9)) - 4) / (static_cast<int>(random.below(3)) + 1);
    square = square + p * p;
    vector.push_back(2 * p);
  }
  vector.push_back(1 - square);
  const Rational scale = Rational(random.below(3) == 0 ? -2 : 1) / (1 + square);
  for (Rational& each : vector) each = each * scale;
  return vector;
}

[[nodiscard]] bool draws_whole_vectors(Draw from) {
  return from == Draw::along_axes || from == Draw::directions || from == Draw::with_lengths;
}

[[nodiscard]] std::vector<Rational> draw_vector(Draw from, Space space, SplitMix& random) {
  if (from == Draw::along_axes) return draw_along_axis(space.dimension, random);
  if (space.dimension != common_space.dimension) return draw_projected(space.dimension, random);
  const std::array<Rational, 3> drawn =
      from == Draw::directions ? draw_direction(from, random) : draw_with_length(random);
  return {drawn.begin(), drawn.end()};
}

/// Each second particle opposite to the one before. The pairs take the axes in turn, so that products of
/// different components have no sum, either.
void balance(SamplePoint& point, const ExprTree& tree, bool all_along_one, SplitMix& random) {
  constexpr std::array lengths{1, 2, 3};
  std::uint32_t turn = 0;
  for (const SymbolId symbol : point.symbols()) {
    const Symbol& named = tree.symbols[symbol];
    if (!named.per_particle || named.rank > 1 || named.unit) continue;
    for (const Coordinate& at : point.coordinates_of(symbol)) {
      if (!point.is_free(at)) continue;
      const std::size_t axis = ((at.particle - 1) / 2 + (all_along_one ? 0 : turn)) % named.axes[0].dimension;
      const Coordinate partner{symbol, at.particle - 1, at.component};
      const bool second = at.particle % 2 == 0;
      const bool along = named.rank == 0 || at.component == axis;
      const Rational drawn = along ? random.pick<int>(lengths) : 0;
      point.set(at, second ? (named.rank == 0 ? point[partner] : -point[partner]) : drawn);
    }
    if (named.rank == 1) ++turn;
  }
}

}  // namespace

void draw(SamplePoint& point, const ExprTree& tree, Draw from, SplitMix& random) {
  for (const Coordinate& at : point.coordinates()) {
    const Symbol& symbol = tree.symbols[at.symbol];
    if (symbol.unit) {
      point.set_all(at.symbol, at.particle, draw_direction(from, random));
      continue;
    }
    if (const Meaning::Kind kind = point.meaning(at.symbol).kind; kind != Meaning::Kind::itself) {
      point.set(at, draw_seen_by_functions(kind, random));
      continue;
    }
    if (symbol.rotation) {
      const bool known = from == Draw::zero_or_one || from == Draw::tiny || from == Draw::along_axes;
      point.set_all(at.symbol, at.particle, draw_rotation(known, random));
      continue;
    }
    if (symbol.rank != 1 || !draws_whole_vectors(from)) {
      point.set(at, draw_number(from, symbol.rank, random));
    } else if (at.component == 0) {
      point.set_all(at.symbol, at.particle, draw_vector(from, symbol.axes[0], random));
    }
  }
  if (from == Draw::balanced || from == Draw::balanced_out)
    balance(point, tree, from == Draw::balanced, random);
}

/// All that may be angles and logarithms are, or some of them: a product of two is nothing exact.
void SampleSequence::choose_meanings(SamplePoint& point, std::uint32_t attempt) {
  constexpr std::array multiples{1, 2, 1, 6};
  const int multiple = multiples[attempt % multiples.size()];
  const auto choose = [&](const std::vector<SymbolId>& symbols, Meaning::Kind kind) {
    for (const SymbolId symbol : symbols) {
      if (attempt % 3 == 0 || random_.below(2) == 0) point.mean(symbol, {kind, multiple});
    }
  };
  choose(reach_->angles, Meaning::Kind::angle);
  choose(reach_->exponents, Meaning::Kind::logarithm);
}

SamplePoint SampleSequence::next() {
  const std::uint32_t attempt = drawn_++;
  if (balanced_ && attempt % 8 == 2) {
    const bool first = attempt % 16 == 2;
    SamplePoint point(*tree_, reach_->symbols, first ? 4 : 6);
    draw(point, *tree_, first ? Draw::balanced : Draw::balanced_out, random_);
    return point;
  }
  SamplePoint point(*tree_, reach_->symbols, reach_->particles ? particles_for(attempt) : 0);
  choose_meanings(point, attempt);
  draw(point, *tree_, draw_for(attempt, reach_->roots), random_);
  return point;
}

SamplePoint made_small(SamplePoint point) {
  constexpr int divisor = 10;
  for (const Coordinate& at : point.coordinates()) {
    if (point.is_free(at)) point.set(at, point[at] / divisor);
  }
  return point;
}

}  // namespace rigor
