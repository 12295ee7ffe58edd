// SPDX-License-Identifier: GPL-3.0-or-later
// An exact sample: a rational value for every free symbol, and for each of N particles. A symbol that
// only functions see may be angles or logarithms instead, given by rational numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/point/scope.h"
#include "algebra/sample/point_value.h"
#include "base/splitmix.h"

namespace rigor {

/// One number of a point that can be chosen freely. A symmetric tensor has six; a unit vector and a
/// rotation have a single one (component 0), which is set as a whole.
struct Coordinate {
  SymbolId symbol{};
  std::uint32_t particle = 0;  // from 1; 0 where the symbol has no particle label
  std::uint32_t component = 0;
  friend bool operator==(const Coordinate&, const Coordinate&) = default;
};

class SamplePoint {
 public:
  SamplePoint(const ExprTree& tree, std::span<const SymbolId> symbols, std::uint32_t particles);

  [[nodiscard]] std::uint32_t particles() const { return particles_; }
  [[nodiscard]] std::span<const SymbolId> symbols() const { return symbols_; }
  [[nodiscard]] const Rational& value(SymbolId symbol, std::uint32_t particle, std::size_t component) const {
    return values_[position(symbol, particle) + component];
  }
  [[nodiscard]] std::span<const Rational> values(SymbolId symbol, std::uint32_t particle) const;
  [[nodiscard]] std::vector<Coordinate> coordinates() const;
  [[nodiscard]] std::vector<Coordinate> coordinates_of(SymbolId symbol) const;

  [[nodiscard]] bool has(SymbolId symbol) const {
    return offset_[static_cast<std::size_t>(symbol)] != absent;
  }
  /// Is it a unit vector or a rotation, all its components at once?
  [[nodiscard]] bool is_whole(const Coordinate& at) const {
    const Symbol& named = tree_->symbols[at.symbol];
    return named.unit || named.rotation;
  }
  /// Is it written twice, off the diagonal of a symmetric tensor?
  [[nodiscard]] bool is_twofold(const Coordinate& at) const {
    const Symbol& named = tree_->symbols[at.symbol];
    return named.symmetric && named.rank == 2 && at.component % 4 != 0;
  }
  /// Can it take any value? Not one that is whole, nor an angle or a logarithm.
  [[nodiscard]] bool is_free(const Coordinate& at) const {
    return !is_whole(at) && meaning(at.symbol).kind == Meaning::Kind::itself;
  }
  [[nodiscard]] const Rational& operator[](const Coordinate& at) const {
    return value(at.symbol, at.particle, at.component);
  }
  /// Sets a number that is not whole, and the components that equal it by symmetry. Where it is to have a
  /// logarithm and is not positive, it becomes 1, whose logarithm is 0.
  void set(const Coordinate& at, const Rational& value);
  /// Sets all components as they are.
  void set_all(SymbolId symbol, std::uint32_t particle, std::span<const Rational> components);

  /// What a symbol's numbers stand for: by default for themselves.
  void mean(SymbolId symbol, const Meaning& meaning) { meaning_[static_cast<std::size_t>(symbol)] = meaning; }
  [[nodiscard]] const Meaning& meaning(SymbolId symbol) const {
    return meaning_[static_cast<std::size_t>(symbol)];
  }
  /// All that the numbers of another point of the same tree stand for.
  void mean_as(const SamplePoint& other) { meaning_ = other.meaning_; }
  /// A number for each symbol and particle: that of its first component; those of the others follow.
  [[nodiscard]] std::size_t place(SymbolId symbol, std::uint32_t particle) const {
    return position(symbol, particle);
  }

  /// After its tree has got more symbols, none of which it has.
  void make_room() {
    offset_.resize(tree_->symbols.size(), absent);
    meaning_.resize(tree_->symbols.size());
  }

  /// The same values for one particle less.
  [[nodiscard]] SamplePoint without_particle(std::uint32_t particle) const;
  /// The same particles, two of them exchanged.
  [[nodiscard]] SamplePoint with_exchanged(std::uint32_t first, std::uint32_t second) const;

 private:
  static constexpr std::uint32_t absent = 0xffffffffu;
  [[nodiscard]] std::size_t position(SymbolId symbol, std::uint32_t particle) const;
  [[nodiscard]] std::uint32_t first_particle(SymbolId symbol) const;
  [[nodiscard]] std::uint32_t last_particle(SymbolId symbol) const;

  const ExprTree* tree_;
  std::vector<SymbolId> symbols_;
  std::uint32_t particles_;
  std::vector<std::uint32_t> offset_;  // by symbol
  std::vector<Rational> values_;
  std::vector<Meaning> meaning_;  // by symbol
};

/// How far a point is from simple: particles first, then numbers that are not 0, then their digits, then how
/// late their axes are. A rotation counts by how strange it is, a tensor's numbers off the diagonal twice.
struct Complexity {
  std::uint32_t particles = 0;
  std::uint32_t nonzero = 0;
  double size = 0;  // Σ |numerator| + 3 (denominator − 1), 3/2 for a minus sign, k − 1 of 2k arctan t
  double lateness = 0;  // of axes and particles, the earlier symbols first
  friend auto operator<=>(const Complexity&, const Complexity&) = default;
};
[[nodiscard]] Complexity complexity(const SamplePoint& point);

/// From which numbers a point is drawn.
enum class Draw : std::uint8_t {
  zero_or_one,   // scalars 1..3, unit vectors along the axes
  tiny,          // components −1..2
  generic,       // components −9..9, seldom 0
  along_axes,    // vectors with one component that is not 0
  directions,    // vectors of length 1, scalars ±1
  balanced,      // pairs of particles: equal scalars, opposite vectors along one axis
  balanced_out,  // the same, not all of a particle's vectors along one axis
  with_lengths,  // vectors of rational length, scalars that are squares: for statements with roots
};

void draw(SamplePoint& point, const ExprTree& tree, Draw from, SplitMix& random);

/// The same with numbers below 1, as an arc sine asks for.
[[nodiscard]] SamplePoint made_small(SamplePoint point);

/// The points that are tried for a statement, always the same ones: numbers of particles and kinds of numbers
/// take turns. Balanced: sums over particles are often to vanish.
class SampleSequence {
 public:
  SampleSequence(const ExprTree& tree, const Reach& reached, bool balanced, std::uint64_t from = seed)
      : tree_(&tree), reach_(&reached), random_(from), balanced_(balanced) {}

  [[nodiscard]] SamplePoint next();
  [[nodiscard]] std::uint32_t drawn() const { return drawn_; }

 private:
  void choose_meanings(SamplePoint& point, std::uint32_t attempt);

  static constexpr std::uint64_t seed = 0x5269676f72;

  const ExprTree* tree_;
  const Reach* reach_;
  SplitMix random_;
  bool balanced_;
  std::uint32_t drawn_ = 0;
};

}  // namespace rigor
