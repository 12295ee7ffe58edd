// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_point.h"

#include <algorithm>

#include "algebra/sample/sample_rotation.h"
#include "base/check.h"

namespace rigor {

SamplePoint::SamplePoint(const ExprTree& tree, std::span<const SymbolId> symbols, std::uint32_t particles)
    : tree_(&tree),
      symbols_(symbols.begin(), symbols.end()),
      particles_(particles),
      offset_(tree.symbols.size(), absent),
      meaning_(tree.symbols.size()) {
  std::size_t size = 0;
  for (const SymbolId symbol : symbols_) {
    offset_[static_cast<std::size_t>(symbol)] = static_cast<std::uint32_t>(size);
    const std::size_t copies = tree.symbols[symbol].per_particle ? particles : 1;
    size += copies * component_count(tree.symbols[symbol]);
  }
  values_.resize(size);
}

std::size_t SamplePoint::position(SymbolId symbol, std::uint32_t particle) const {
  const Symbol& named = tree_->symbols[symbol];
  const std::uint32_t offset = offset_[static_cast<std::size_t>(symbol)];
  RIGOR_CHECK(offset != absent, named.name);
  RIGOR_CHECK(particle <= particles_ && (particle > 0) == named.per_particle, named.name, particle,
              particles_);
  return offset + (named.per_particle ? particle - 1 : 0) * component_count(named);
}

std::span<const Rational> SamplePoint::values(SymbolId symbol, std::uint32_t particle) const {
  return std::span(values_).subspan(position(symbol, particle), component_count(tree_->symbols[symbol]));
}

std::uint32_t SamplePoint::first_particle(SymbolId symbol) const {
  return tree_->symbols[symbol].per_particle ? 1 : 0;
}

std::uint32_t SamplePoint::last_particle(SymbolId symbol) const {
  return tree_->symbols[symbol].per_particle ? particles_ : 0;
}

std::vector<Coordinate> SamplePoint::coordinates() const {
  std::vector<Coordinate> all;
  for (const SymbolId symbol : symbols_) {
    const std::vector<Coordinate> own = coordinates_of(symbol);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::vector<Coordinate> SamplePoint::coordinates_of(SymbolId symbol) const {
  std::vector<Coordinate> all;
  const Symbol& named = tree_->symbols[symbol];
  const auto count = static_cast<std::uint32_t>(named.unit || named.rotation ? 1 : component_count(named));
  for (std::uint32_t particle = first_particle(symbol); particle <= last_particle(symbol); ++particle) {
    for (std::uint32_t component = 0; component < count; ++component) {
      if (canonical_component(named, component) == component) all.push_back({symbol, particle, component});
    }
  }
  return all;
}

void SamplePoint::set(const Coordinate& at, const Rational& value) {
  const Symbol& named = tree_->symbols[at.symbol];
  const std::size_t first = position(at.symbol, at.particle);
  const bool lacks_logarithm = meaning(at.symbol).kind == Meaning::Kind::logarithm && !cln::plusp(value);
  for (std::size_t component = 0; component < component_count(named); ++component) {
    if (canonical_component(named, component) == at.component)
      values_[first + component] = lacks_logarithm ? Rational(1) : value;
  }
}

void SamplePoint::set_all(SymbolId symbol, std::uint32_t particle, std::span<const Rational> components) {
  std::copy(components.begin(), components.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(position(symbol, particle)));
}

SamplePoint SamplePoint::without_particle(std::uint32_t particle) const {
  SamplePoint smaller(*tree_, symbols_, particles_ - 1);
  smaller.mean_as(*this);
  for (const SymbolId symbol : symbols_) {
    for (std::uint32_t p = first_particle(symbol); p <= last_particle(symbol); ++p) {
      if (p == 0 || p != particle) smaller.set_all(symbol, p > particle ? p - 1 : p, values(symbol, p));
    }
  }
  return smaller;
}

SamplePoint SamplePoint::with_exchanged(std::uint32_t first, std::uint32_t second) const {
  SamplePoint exchanged = *this;
  for (const SymbolId symbol : symbols_) {
    if (!tree_->symbols[symbol].per_particle) continue;
    exchanged.set_all(symbol, first, values(symbol, second));
    exchanged.set_all(symbol, second, values(symbol, first));
  }
  return exchanged;
}

Complexity complexity(const SamplePoint& point) {
  constexpr double fade = 1.0 / 32;
  Complexity result{.particles = point.particles()};
  double weight = 1;
  for (const Coordinate& at : point.coordinates()) {
    const auto all = point.values(at.symbol, at.particle);
    if (!cln::zerop(point[at])) result.size += point.meaning(at.symbol).multiple - 1;
    const bool rotation = point.is_whole(at) && all.size() == 9;
    if (rotation) result.nonzero += strangeness(all);
    const std::span<const Rational> own = point.is_whole(at) ? all : all.subspan(at.component, 1);
    for (std::size_t k = 0; k < own.size(); ++k) {
      const Rational& value = own[k];
      if (cln::zerop(value)) continue;
      if (!rotation) {
        result.nonzero += point.is_twofold(at) ? 2 : 1;
        result.lateness += weight * static_cast<double>(at.component + k + at.particle) / 64;
        weight *= fade;
      }
      result.size += cln::double_approx(cln::abs(cln::numerator(value))) +
                     3 * (cln::double_approx(cln::denominator(value)) - 1) + (cln::minusp(value) ? 1.5 : 0.0);
    }
  }
  return result;
}

}  // namespace rigor
