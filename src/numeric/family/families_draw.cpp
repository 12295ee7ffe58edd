// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/splitmix.h"
#include "numeric/body/inertia.h"
#include "numeric/family/families.h"
#include "numeric/family/family_letters.h"
#include "numeric/family/family_values.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {
namespace {

constexpr std::size_t most_numbers = std::size_t{1} << 20;  // of one component, for all particles and samples

class Drawer {
 public:
  Drawer(const ExprTree& tree, const InputFamily& family, const DrawOptions& options,
         const Position& thin_axis, std::vector<SymbolId> vectors)
      : tree_(tree),
        family_(family),
        options_(options),
        thin_axis_(thin_axis),
        vectors_(std::move(vectors)),
        samples_(options.samples, options.body != nullptr ? options.body->size() : options.particles) {}

  void draw(SymbolId id) {
    const Symbol& symbol = tree_.symbols[id];
    if (symbol.unit_of_measure) return samples_.set(id, 0, 1);
    const std::size_t particles = symbol.per_particle ? samples_.particles() : 1;
    const bool varies = particles == 1 || particles * samples_.samples() <= most_numbers;
    const std::size_t samples = varies ? samples_.samples() : 1;
    auto columns = columns_of(symbol, particles * samples);
    SplitMix bits = stream(static_cast<std::uint64_t>(id) + 1);
    for (std::size_t particle = 0; particle < particles; ++particle) {
      for (std::size_t sample = 0; sample < samples; ++sample) {
        const std::vector<double> value = value_of(id, symbol, sample, bits);
        for (auto& [component, column] : columns) column[particle * samples + sample] = value[component];
      }
    }
    for (auto& [component, column] : columns) {
      if (!symbol.per_particle)
        samples_.set_each(id, component, std::move(column));
      else if (varies)
        samples_.set_particles_each(id, component, std::move(column));
      else
        samples_.set_particles(id, component, std::move(column));
    }
  }

  void set_body(const Body& body, const BodyLetters& letters) {
    if (letters.mass) samples_.set_particles(*letters.mass, 0, body.masses);
    if (!letters.position) return;
    for (std::uint32_t axis = 0; axis < 3; ++axis)
      samples_.set_particles(*letters.position, axis, body.positions[axis]);
  }

  [[nodiscard]] Samples take() { return std::move(samples_); }

 private:
  using NamedColumns = std::vector<std::pair<std::uint32_t, std::vector<double>>>;

  /// A column for each component that does not equal an earlier one.
  static NamedColumns columns_of(const Symbol& symbol, std::size_t length) {
    std::uint32_t components = 1;
    for (int k = 0; k < symbol.rank; ++k) components *= 3;
    NamedColumns columns;
    for (std::uint32_t component = 0; component < components; ++component) {
      if (canonical_component(symbol, component) == component)
        columns.emplace_back(component, std::vector<double>(length));
    }
    return columns;
  }

  [[nodiscard]] SplitMix stream(std::uint64_t number) const {
    return SplitMix(SplitMix(options_.seed + number * 0xd1342543de82ef95u).next());
  }
  /// What all symbols of one sample share.
  [[nodiscard]] SplitMix shared(std::size_t sample) const {
    return stream((std::uint64_t{1} << 40) + sample);
  }

  std::vector<double> value_of(SymbolId id, const Symbol& symbol, std::size_t sample, SplitMix& bits) {
    if (symbol.rank == 0) return {scalar(symbol, sample, bits)};
    if (symbol.rank == 1) {
      const Position value = vector(id, symbol, sample, bits);
      return {value.begin(), value.end()};
    }
    if (symbol.rank == 2 && (symbol.rotation || symbol.symmetric)) {
      const InertiaTensor value = symbol.rotation ? rotation(bits) : symmetric(symbol, bits);
      std::vector<double> row_by_row;
      for (const Position& row : value) row_by_row.insert(row_by_row.end(), row.begin(), row.end());
      return row_by_row;
    }
    std::size_t components = 1;
    for (int k = 0; k < symbol.rank; ++k) components *= 3;
    std::vector<double> value(components);
    for (double& x : value) x = component(bits);
    return value;
  }

  /// Which of the free vectors it is, from 0.
  [[nodiscard]] std::size_t number_of(SymbolId id) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(vectors_, id) - vectors_.begin());
  }

  double component(SplitMix& bits) const {
    return family_.kind == FamilyKind::integers ? draw_integer(bits) : uniform_sign(bits);
  }

  double scalar(const Symbol& symbol, std::size_t sample, SplitMix& bits) const {
    if (family_.kind == FamilyKind::integers) return 1 + std::abs(draw_integer(bits));
    const double own = draw_positive(bits);
    const auto letter = family_.kind == FamilyKind::gap ? numbered_letter(symbol) : std::nullopt;
    if (!letter) return own;
    SplitMix common = shared(sample);
    for (const char c : letter->base) common = SplitMix(common.next() + static_cast<unsigned char>(c));
    return draw_positive(common) * (1 + family_.size * letter->number);
  }

  Position vector(SymbolId id, const Symbol& symbol, std::size_t sample, SplitMix& bits) const {
    Position value = direction(id, symbol, sample, bits);
    if (symbol.unit) return normalised(value);
    if (family_.kind != FamilyKind::lengths || symbol.per_particle) return value;
    for (double& x : value) x = number_of(id) == 0 ? x * family_.size : x / family_.size;
    return value;
  }

  Position direction(SymbolId id, const Symbol& symbol, std::size_t sample, SplitMix& bits) const {
    SplitMix common = shared(sample);
    const bool is_free = !symbol.per_particle;
    if (family_.kind == FamilyKind::gap && has_gap_between_components(symbol)) {
      const double base = draw_positive(bits);
      return {base, base * (1 + family_.size), base * (1 + 2 * family_.size)};
    }
    if (is_free && family_.kind == FamilyKind::thin_axis) return scaled(thin_axis_, draw_positive(bits));
    if (is_free && family_.kind == FamilyKind::angle) {
      const Position axis = draw_direction(common);
      const double length = draw_positive(bits);
      const Position side = perpendicular(axis, draw_direction(bits));
      return scaled(number_of(id) == 0 ? axis : sum(axis, scaled(side, family_.size)), length);
    }
    if (is_free && family_.kind == FamilyKind::orthogonal) {
      const InertiaTensor axes = integer_axes(common);
      const double power_of_two = std::ldexp(1.0, static_cast<int>(bits.below(5)) - 2);
      return scaled(axes[number_of(id) % 3], power_of_two);
    }
    if (symbol.unit) return draw_direction(bits);
    Position value{};
    do {
      for (double& x : value) x = component(bits);
    } while (value == Position{});
    return value;
  }

  InertiaTensor rotation(SplitMix& bits) const {
    if (family_.kind == FamilyKind::integers || family_.kind == FamilyKind::orthogonal)
      return rotation_of(draw_integer_quaternion(bits));
    if (family_.kind != FamilyKind::angle) return rotation_of(draw_quaternion(bits));
    const Position axis = draw_direction(bits);
    const double half = family_.size / 2;
    return rotation_of({1, half * axis[0], half * axis[1], half * axis[2]});
  }

  InertiaTensor symmetric(const Symbol& symbol, SplitMix& bits) const {
    if (family_.kind == FamilyKind::gap && has_gap_between_components(symbol)) {
      const double base = draw_positive(bits);
      return with_eigenvalues({base, base * (1 + family_.size), base * (1 + 2 * family_.size)},
                              rotation_of(draw_quaternion(bits)));
    }
    InertiaTensor rows{};
    for (Position& row : rows) {
      for (double& x : row) x = component(bits);
    }
    return inertia_of_rows(rows);
  }

  const ExprTree& tree_;
  const InputFamily& family_;
  const DrawOptions& options_;
  Position thin_axis_;
  std::vector<SymbolId> vectors_;  // free, in the order of the table
  Samples samples_;
};

Result<Position> least_axis(const Body* body) {
  if (body == nullptr) return refuse("the family `thin axis` needs a body");
  return inertia_tensor(*body)
      .and_then([](const InertiaTensor& inertia) { return principal_axes(inertia); })
      .map([](const PrincipalAxes& principal) { return principal.axes[0]; });
}

}  // namespace

Result<Samples> draw_samples(const ExprTree& tree, std::span<const SymbolId> symbols,
                             const InputFamily& family, const DrawOptions& options) {
  Position thin_axis{};
  if (family.kind == FamilyKind::thin_axis) {
    const auto axis = least_axis(options.body);
    if (!axis) return tl::unexpected(axis.error());
    thin_axis = *axis;
  }
  std::vector<SymbolId> vectors;
  for (const SymbolId id : symbols) {
    if (is_free_vector(tree.symbols[id])) vectors.push_back(id);
  }
  std::ranges::sort(vectors);
  Drawer drawer(tree, family, options, thin_axis, std::move(vectors));
  for (const SymbolId id : symbols) {
    const bool is_given =
        options.body != nullptr && (id == options.letters.mass || id == options.letters.position);
    if (!is_given) drawer.draw(id);
  }
  if (options.body != nullptr) drawer.set_body(*options.body, options.letters);
  return drawer.take();
}

}  // namespace rigor
