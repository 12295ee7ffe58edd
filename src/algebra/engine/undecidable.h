// SPDX-License-Identifier: GPL-3.0-or-later
// Why an exact procedure gave up. Thrown and caught inside this floor: `decide` makes it a verdict with a
// reason.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace rigor {

class Undecidable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  // the reason: lower case, no full stop
};

/// Assumptions that have no solution: nothing is proved from them.
class Contradiction : public Undecidable {
 public:
  Contradiction() : Undecidable("the assumptions contradict each other") {}
};

/// A root of what is negative for all values: the statement says nothing about real numbers.
class NoRealValue : public Undecidable {
 public:
  using Undecidable::Undecidable;
};

/// A sample at which the statement says nothing: a division by zero, a root of a negative number, or one that
/// is not rational.
class PointRejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A sample at which both sides have a value, and these lie too near each other to be told apart.
class ValuesTooNear : public PointRejected {
 public:
  using PointRejected::PointRejected;
};

inline constexpr int largest_exponent = 64;
inline constexpr int largest_rank = 4;
inline constexpr std::size_t largest_free_indices = 6;
inline constexpr std::size_t largest_digits = 1000;
inline constexpr double largest_bits = 3322;  // of 1000 decimal digits
inline constexpr std::uint32_t largest_depth =
    800;  // of nodes and unfolded definitions, one inside the other

}  // namespace rigor
