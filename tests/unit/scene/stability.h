// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas of notes for a nearly steady spin, against the motion that the notes' own equations give: a spin
// about one axis with a small push across it, followed until an event from which a frequency or a rate of
// growth is read.
// The spin about axis k starts with the part δ of its size across it, along the next axis in cyclic order.
//   oscillation: the component along the axis after that is 0 again after half a turn, τ: Ω² = (π/τ)²
//   growth: the push has doubled after τ; it grows as cosh: Ω² = −(arcosh 2 / τ)²
//   neither (the formula gives 0): Ω² = −(second difference of the push over 1/ω)/δ
// Both hold to first order in δ, so that Ω² errs by a multiple of δ².
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/motion/motion.h"

namespace rigor {

enum class SpinFate : std::uint8_t { oscillates, grows, neither };
[[nodiscard]] std::string_view name_of(SpinFate fate);

/// A function of the spin, components along the body's axes.
using SpinFunction = std::function<double(const Vector3&)>;

struct StabilityPoint {
  double push = 0;      // δ, over the size of the spin
  double measured = 0;  // Ω², in 1/s²; not a number: the event did not come
  double error = 0;     // |measured − predicted|, over |predicted|, or over ω² where that is 0
};

struct StabilityMeasurement {
  std::size_t axis = 0;  // from 0
  SpinFate fate = SpinFate::neither;
  double predicted = 0;  // Ω², at the steady spin
  std::vector<StabilityPoint> points;
  double order = 0;  // how the error falls with the push: the slope between the first and the last point that
                     // is above 1e-10; not a number: fewer than two are
  std::string problem;  // why nothing, or not everything, was measured; else empty
};

/// `squared`: the notes' Ω² for this axis. Taken for 0 below 1e-9 ω².
[[nodiscard]] StabilityMeasurement measure_stability(const SpinRates& rates, const SpinFunction& squared,
                                                     std::size_t axis, double spin,
                                                     std::span<const double> pushes);

}  // namespace rigor
