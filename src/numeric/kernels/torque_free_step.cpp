// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

constexpr std::size_t block = 1024;

/// The bodies from `first` on.
FreeBodies part_of(const FreeBodies& all, std::size_t first, std::size_t count) {
  FreeBodies part = all;
  part.count = count;
  for (std::size_t i = 0; i < 3; ++i) {
    part.moments[i] += first;
    part.spin[i] += first;
  }
  for (double*& column : part.attitude) column += first;
  if (part.times != nullptr) part.times += first;
  return part;
}

/// q r, of length 1.
AttitudeQuaternion unit_product(const AttitudeQuaternion& q, const AttitudeQuaternion& r) {
  AttitudeQuaternion product{q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3]};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    product[1 + i] = q[0] * r[1 + i] + q[1 + i] * r[0] + q[1 + j] * r[1 + k] - q[1 + k] * r[1 + j];
  }
  double square = 0;
  for (const double part : product) square += part * part;
  for (double& part : product) part /= std::sqrt(square);
  return product;
}

/// By any step. False: it has no motion.
bool move_one(const FreeBodies& bodies, std::size_t at) {
  Position moments{};
  Position spin{};
  AttitudeQuaternion attitude{};
  for (std::size_t i = 0; i < 3; ++i) {
    moments[i] = bodies.moments[i][at];
    spin[i] = bodies.spin[i][at];
  }
  for (std::size_t i = 0; i < 4; ++i) attitude[i] = bodies.attitude[i][at];
  const double time = bodies.times == nullptr ? bodies.time : bodies.times[at];
  const auto motion = TorqueFree::make(moments, spin);
  const auto turn = TorqueFreeAttitude::make(moments, spin);
  bool moves = motion && turn;
  if (moves) {
    spin = motion->spin(time);
    attitude = unit_product(attitude, turn->at(time));
    moves = are_finite(spin);
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < 3; ++i) bodies.spin[i][at] = moves ? spin[i] : nan;
  for (std::size_t i = 0; i < 4; ++i) bodies.attitude[i][at] = moves ? attitude[i] : nan;
  return moves;
}

}  // namespace

std::size_t step_free_bodies(const FreeBodies& bodies, const LaneKernels& kernels) {
  std::array<std::size_t, block> beyond;
  std::size_t refused = 0;
  for (std::size_t first = 0; first < bodies.count; first += block) {
    const FreeBodies part = part_of(bodies, first, std::min(block, bodies.count - first));
    const std::size_t count = kernels.step_free_bodies(part, beyond.data());
    for (std::size_t i = 0; i < count; ++i)
      if (!move_one(part, beyond[i])) ++refused;
  }
  return refused;
}

}  // namespace rigor
