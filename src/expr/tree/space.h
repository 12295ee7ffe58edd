// SPDX-License-Identifier: GPL-3.0-or-later
// The spaces that indices run over, and the axes of a value in them. Spaces are Euclidean: their metric is δ,
// so an upper and a lower index mean the same; only in space-time they differ, by signs that are written out.
// Operations that exist in three dimensions only (ε with three indices, the cross product, rotations by
// quaternions) are only made in a space of three.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rigor {

inline constexpr int most_dimensions = 9;     // literal axes are one digit
inline constexpr int most_axes_apart = 8;     // axes of a value with one outside the common space
inline constexpr int most_named_spaces = 12;  // their ids are 1, 2, …

/// A value, not a name: two spaces of one dimension differ by their ids.
struct Space {
  std::uint8_t dimension = 3;
  std::uint8_t id = 0;  // 0: the common space of three real dimensions
  friend bool operator==(const Space&, const Space&) = default;
};
inline constexpr Space common_space{};
/// Four axes, of which the first is along the time. Components are those with upper indices; one with a lower
/// index is that times a sign (elaborate/reading/space_time.h).
inline constexpr Space space_time{4, 13};
/// All columns of one length that no named space has: entries 1, 2, … of what is written in rows.
inline constexpr std::uint8_t space_of_columns = 14;  // its id
/// The axis that says which part of a complex number it is.
inline constexpr Space space_of_parts{2, 15};

/// The spaces of a value's axes, outermost first; their number is the value's rank. One byte an axis; 0 is
/// the common space, so that a value in it has no cost and compares as 0.
class AxisSpaces {
 public:
  constexpr AxisSpaces() = default;
  /// `rank` axes of one space.
  [[nodiscard]] static constexpr AxisSpaces of(Space space, int rank) {
    AxisSpaces axes;
    if (space == common_space) return axes;
    for (int k = 0; k < rank; ++k) axes.set(k, space);
    return axes;
  }
  [[nodiscard]] constexpr Space operator[](int axis) const {
    const auto byte = axis < most_axes_apart ? (packed_ >> (8 * axis)) & 0xffU : 0;
    if (byte == 0) return common_space;
    return {static_cast<std::uint8_t>(byte & 0xfU), static_cast<std::uint8_t>(byte >> 4U)};
  }
  constexpr void set(int axis, Space space) {
    if (axis >= most_axes_apart) return;
    const std::uint64_t byte = space == common_space ? 0 : (space.id << 4U) | space.dimension;
    packed_ = (packed_ & ~(std::uint64_t{0xff} << (8 * axis))) | (byte << (8 * axis));
  }
  [[nodiscard]] constexpr bool are_common() const { return packed_ == 0; }
  /// The axes of a value of this rank, followed by `more`.
  [[nodiscard]] constexpr AxisSpaces then(int rank, AxisSpaces more) const {
    AxisSpaces all = first(rank);
    if (rank < most_axes_apart) all.packed_ |= more.packed_ << (8 * rank);
    return all;
  }
  [[nodiscard]] constexpr AxisSpaces first(int count) const {
    AxisSpaces some;
    some.packed_ = count >= most_axes_apart ? packed_ : packed_ & ((std::uint64_t{1} << (8 * count)) - 1);
    return some;
  }
  [[nodiscard]] constexpr AxisSpaces without_first(int count) const {
    AxisSpaces rest;
    rest.packed_ = count >= most_axes_apart ? 0 : packed_ >> (8 * count);
    return rest;
  }
  friend bool operator==(const AxisSpaces&, const AxisSpaces&) = default;

 private:
  std::uint64_t packed_ = 0;
};

/// Of a value of that rank: 1, 3, 9, … in the common space.
[[nodiscard]] constexpr std::size_t component_count(int rank, AxisSpaces axes = {}) {
  std::size_t count = 1;
  for (int axis = 0; axis < rank; ++axis) count *= axes[axis].dimension;
  return count;
}

}  // namespace rigor
