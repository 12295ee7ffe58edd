// SPDX-License-Identifier: GPL-3.0-or-later
// A sample body: point masses, as data for programs over m_α and r_α. SI units: kg, m.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "numeric/exact/exact_moments.h"
#include "numeric/kernels/mass_sums.h"
#include "numeric/kernels/position.h"

namespace rigor {

struct ExactBody;

/// What is known of a body without summing over its particles as they are held.
struct KnownInertia {
  double mass = 0;
  InertiaTensor inertia{};                         // about the centre of mass, along the body's axes
  InertiaTensor low{};                             // to be added to it
  bool is_sharp = false;                           // inertia + low is what is said of the body, to `error`
  double error = 0;                                // kg m², bound of the error of any entry
  double mass_error = 0;                           // bound, relative to the mass
  std::shared_ptr<const ExactBody> integers = {};  // the same without an error: of what parts may be made of
  std::shared_ptr<const ExactMoments> exact = {};  // where the above leaves open whether moments differ
};

/// How far masses and places, as they are held, may be from those of the body that was described: bounds. The
/// described body is that of the doubles that were given, in SI units.
struct BodyErrors {
  double mass = 0;                               // of each, relative to itself
  double place = 0;                              // of each coordinate, relative to itself,
  double shift = 0;                              // m, and on top of that,
  std::array<std::vector<double>, 3> each = {};  // and of this one of this particle, unless it is empty
};

/// Made by the functions below, which guarantee what `check_body` asks for, and that the centre of mass is
/// the origin to rounding.
struct Body {
  std::string name;
  std::vector<double> masses;
  std::array<std::vector<double>, 3> positions;  // x, y and z of all particles
  std::optional<KnownInertia> known = {};  // of the solid that the particles stand for, or where they were
  std::string title = {};                  // in words, for reports; may be empty
  BodyErrors errors = {};

  [[nodiscard]] std::size_t size() const { return masses.size(); }
  [[nodiscard]] Position position(std::size_t particle) const {
    return {positions[0][particle], positions[1][particle], positions[2][particle]};
  }
};

/// At least one particle; masses finite and not negative, their sum finite and positive; coordinates finite.
/// The reason names the first particle (from 1) that is wrong.
[[nodiscard]] Result<void> check_body(const Body& body);
/// The part of it that sums over the particles do not find by themselves: at most `most_particles`.
[[nodiscard]] Result<void> check_count(const Body& body);

/// The body's particles, which are not copied.
[[nodiscard]] PointColumns points_of(const Body& body);

/// x − centre. Error: u |x − centre| + u² |centre|, first order.
[[nodiscard]] double away_from(double x, const HighLow& centre);

/// Checks a body and moves its centre of mass, known to 100 bits, to the origin: coordinates are rounded
/// as `away_from` says, which is added to the errors. Residue: u times its mean distance from there at most,
/// wherever it was before, as far as its coordinates had the digits. Cost: O(N).
[[nodiscard]] Result<Body> centred(Body body);

/// (x − centre) unit of coordinates x along an axis, each `stride` after the one before, one after the other
/// into `into`, which may be where they are. Bounds of what that rounds:
struct MoveErrors {
  bool rounded = false;  // by u of itself, or twice that if by the unit, too
  double shift = 0;      // m
};
[[nodiscard]] MoveErrors move_coordinates(const double* coordinates, std::size_t stride,
                                          const HighLow& centre, double unit, std::span<double> into);

/// What is known of the inertia of points from their sharp sums, in units of `unit` m; nothing
/// where that overflows.
[[nodiscard]] std::optional<KnownInertia> known_inertia(const SharpMassSums& sums, double unit = 1);

/// Point masses at given places, about their own centre of mass; their inertia is known as it was there.
[[nodiscard]] Result<Body> point_masses(std::string name, const std::vector<double>& masses,
                                        const std::vector<Position>& positions);

/// Masses uniform in (0, 1] kg at places uniform in the cube |x|, |y|, |z| ≤ 1 m, then about their centre of
/// mass. The same for the same seed on every machine. At most `most_particles`.
[[nodiscard]] Result<Body> random_cloud(std::string name, std::size_t count, std::uint64_t seed);

inline constexpr std::size_t most_particles = 10'000'000;

/// A rigid body's moments are finite, not negative, and none exceeds the sum of the others (a plate has
/// equality). An excess of up to 4 units in the last place of the greatest moment is taken for rounding and
/// accepted; nothing else is. The excess is computed exactly.
[[nodiscard]] Result<void> check_moments(const Position& moments);

/// The same for a tensor, which is symmetric to the last bit: ½ tr(I) 1 − I, the second moments, must have no
/// negative eigenvalue. Tolerance: 4 units in the last place of the greatest entry for I₁ + I₂ − I₃.
[[nodiscard]] Result<void> check_inertia(const InertiaTensor& inertia);

}  // namespace rigor
