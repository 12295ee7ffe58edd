// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free_attitude.h"

#include "base/check.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

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
