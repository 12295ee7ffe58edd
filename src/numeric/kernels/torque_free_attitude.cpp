// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free_attitude.h"

#include "base/check.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

std::array<Position, 3> matrix_of(const AttitudeQuaternion& attitude) {
  std::array<Position, 3> matrix{};
  const double w = attitude[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double a = attitude[1 + i];
    const double b = attitude[1 + j];
    const double c = attitude[1 + k];
    matrix[i][i] = 1 - 2 * (b * b + c * c);
    matrix[i][j] = 2 * (a * b - w * c);
    matrix[j][i] = 2 * (a * b + w * c);
  }
  return matrix;
}

Result<TorqueFreeAttitude> TorqueFreeAttitude::make(const Position& moments, const Position& spin) {
  const auto motion = TorqueFree::make(moments, spin);
  if (!motion) return tl::unexpected(motion.error());
  Result<TorqueFreeAttitude> attitude(tl::in_place);
  lane_kernels().set_free_attitude(moments.data(), spin.data(), attitude->attitude_);
  return attitude;
}

AttitudeQuaternion TorqueFreeAttitude::at(double time) const {
  AttitudeQuaternion attitude;
  lane_kernels().attitude_at(attitude_, time, attitude.data());
  return attitude;
}

void TorqueFreeAttitude::at(std::span<const double> times, std::span<AttitudeQuaternion> into) const {
  RIGOR_CHECK(into.size() == times.size());
  if (!times.empty()) lane_kernels().attitudes_at(attitude_, times.data(), times.size(), into.data()->data());
}

}  // namespace rigor
