// SPDX-License-Identifier: GPL-3.0-or-later
// The simplest samples by enumeration: everything is 0 but one, two or three numbers of the claim. Those with
// fewer numbers come first, then those along earlier axes of earlier symbols, so that A×B = B×A gets the
// first and the second axis.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "algebra/sample/refute.h"
#include "algebra/sample/sample_rotation.h"

namespace rigor {
namespace {

constexpr std::size_t most_numbers = 3;       // that are not 0
constexpr std::size_t most_known_wholes = 7;  // unit vectors along axes, quarter turns: those tried here

/// One number with a value that it may take instead of the one in the background.
struct Choice {
  Coordinate at;
  std::vector<Rational> value;  // of a unit vector or a rotation: all components
};

void put(SamplePoint& point, const Choice& choice) {
  if (point.is_whole(choice.at)) {
    point.set_all(choice.at.symbol, choice.at.particle, choice.value);
  } else {
    point.set(choice.at, choice.value.front());
  }
}

/// All 0, but for scalars (which may be 1), unit vectors (along the first axis), rotations (the identity).
[[nodiscard]] SamplePoint background(const ExprTree& tree, SamplePoint point, int scalar) {
  for (const Coordinate& at : point.coordinates()) {
    const Symbol& symbol = tree.symbols[at.symbol];
    if (point.is_whole(at)) {
      point.set_all(at.symbol, at.particle, simple_wholes(symbol).front());
    } else if (point.meaning(at.symbol).kind == Meaning::Kind::logarithm) {
      point.set(at, 1);
    } else {
      point.set(at, symbol.rank == 0 && point.is_free(at) ? scalar : 0);
    }
  }
  return point;
}

/// What the numbers of the claim's own symbols may be; scalars only where the background has them at 0.
[[nodiscard]] std::vector<Choice> choices_of(const ExprTree& tree, const SamplePoint& point,
                                             std::span<const SymbolId> symbols, int scalar,
                                             std::span<const int> values) {
  std::vector<Choice> choices;
  for (const SymbolId id : symbols) {
    for (const Coordinate& at : point.coordinates_of(id)) {
      const Symbol& symbol = tree.symbols[id];
      if (point.is_whole(at)) {
        const auto wholes = simple_wholes(symbol);
        for (std::size_t k = 1; k < std::min(wholes.size(), most_known_wholes); ++k)
          choices.push_back({at, wholes[k]});
        continue;
      }
      for (const int value : values) {
        const bool in_background = symbol.rank == 0 && value == scalar;
        if (!in_background) choices.push_back({at, {value}});
      }
    }
  }
  return choices;
}

/// The next k of n numbers in their order; false after the last.
[[nodiscard]] bool next_subset(std::vector<std::size_t>& subset, std::size_t n) {
  const std::size_t k = subset.size();
  for (std::size_t i = k; i-- > 0;) {
    if (subset[i] + (k - i) >= n) continue;
    ++subset[i];
    for (std::size_t j = i + 1; j < k; ++j) subset[j] = subset[j - 1] + 1;
    return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<Rational>> simple_wholes(const Symbol& symbol) {
  std::vector<std::vector<Rational>> all;
  if (symbol.rotation) {
    for (const RotationMatrix& each : known_rotations()) all.emplace_back(each.begin(), each.end());
    return all;
  }
  const std::size_t dimension = component_count(symbol);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    all.emplace_back(dimension, Rational(0));
    all.back()[axis] = 1;
  }
  return all;
}

/// All points over one background, as long as they can be simpler than the best.
void Refuter::look_among_few(Counterexample& best, std::uint32_t particles, int scalar,
                             std::span<const int> values) {
  const ExprTree& tree = scope_->tree();
  SamplePoint empty(tree, reach_.symbols, particles);
  empty.mean_as(best.drawn);
  const SamplePoint base = background(tree, std::move(empty), scalar);
  const std::vector<Choice> choices = choices_of(tree, base, claim_symbols_, scalar, values);
  for (std::size_t k = 0; k <= std::min(most_numbers, choices.size()); ++k) {
    const Complexity before = complexity(best.point);
    const bool all_ones = before.size <= before.nonzero;
    if (before.particles <= particles && before.nonzero < k + (all_ones ? 1 : 0)) return;
    std::vector<std::size_t> subset(k);
    for (std::size_t i = 0; i < k; ++i) subset[i] = i;
    do {
      if (looks_left_ == 0 || !may_shrink()) return;
      --looks_left_;
      SamplePoint point = base;
      for (const std::size_t which : subset) put(point, choices[which]);
      consider(best, point, best.attempt);
    } while (k > 0 && next_subset(subset, choices.size()));
    if (complexity(best.point) < before && scalar == 0) return;
  }
}

void Refuter::look_among_few(Counterexample& best) {
  constexpr std::array ones{1};
  constexpr std::array twos{1, 2, -1};
  const std::uint32_t particles = best.point.particles();
  const Complexity before = complexity(best.point);
  const auto look = [&](int scalar, std::span<const int> values) {
    looks_left_ = solver_.none() ? most_looks : most_solved_looks;
    look_among_few(best, particles, scalar, values);
  };
  const SymbolTable& symbols = scope_->tree().symbols;
  const bool has_scalars =
      std::ranges::any_of(reach_.symbols, [&](SymbolId symbol) { return symbols[symbol].rank == 0; });
  look(1, ones);
  if (has_scalars) look(0, ones);
  if (!(complexity(best.point) < before)) look(1, twos);
}

}  // namespace rigor
