// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {
namespace {

const char* fault_of(const Position& moments, const Position& spin) {
  if (!are_finite(moments)) return "a moment is not finite";
  if (!are_finite(spin)) return "the spin is not finite";
  const auto [least, greatest] = std::ranges::minmax_element(moments);
  if (*least < 0) return "a moment is negative";
  if (*least == 0) return "a moment is zero: nothing determines the spin about its axis";
  if (*least < *greatest * 0x1p-200) return "the moments are too unlike";
  return nullptr;
}

/// So near that e-foldings from there leave the range of doubles: by less than 2^-800.
bool is_lost_at_middle_axis(const FreeSpin& spin) {
  if (spin.kind != FreeSpinKind::hyperbolic) return false;
  const auto size = [&](int i) { return std::abs(spin.spin[spin.axis[i]]); };
  return std::max(size(0), size(2)) * 0x1p800 < size(1);
}

}  // namespace

Position free_spin_rates(const Position& moments, const Position& spin) {
  Position rates{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    rates[i] = (moments[j] - moments[k]) / moments[i] * spin[j] * spin[k];
  }
  return rates;
}

Result<TorqueFree> TorqueFree::make(const Position& moments, const Position& spin) {
  if (const char* fault = fault_of(moments, spin)) return refuse(fault);
  Result<TorqueFree> motion(tl::in_place);
  lane_kernels().set_free_spin(moments.data(), spin.data(), motion->spin_);
  if (!are_finite(motion->spin_.amplitude))
    motion = refuse("the spin grows beyond all doubles");
  else if (is_lost_at_middle_axis(motion->spin_))
    motion = refuse("the spin is too near to the middle axis");
  return motion;
}

Position TorqueFree::spin(double time) const {
  Position spin;
  lane_kernels().free_spin_at(spin_, time, spin.data());
  return spin;
}

void TorqueFree::spins(std::span<const double> times, std::span<Position> into) const {
  RIGOR_CHECK(into.size() == times.size());
  if (!times.empty()) lane_kernels().free_spins_at(spin_, times.data(), times.size(), into.data()->data());
}

}  // namespace rigor
