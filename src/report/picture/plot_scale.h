// SPDX-License-Identifier: GPL-3.0-or-later
// From values to places along an axis of a plot, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct Tick {
  double value = 0;
  std::string label;  // for `svg_label`; empty: a tick without a number
};

/// A range of values, drawn from 0 to 1; on a logarithmic scale all are positive.
struct PlotScale {
  bool logarithmic = false;
  double low = 0;
  double high = 1;

  /// 0 at `low`, 1 at `high`. On a logarithmic scale the value must be positive.
  [[nodiscard]] double place(double value) const;
};

/// A scale that shows all these values and some room around them. Values that cannot be drawn on it (not
/// finite, or not positive on a logarithmic one) do not count; if none is left, any range is as good.
[[nodiscard]] PlotScale fitting_scale(const std::vector<double>& values, bool logarithmic);

/// At round values, at most about ten.
[[nodiscard]] std::vector<Tick> ticks_of(const PlotScale& scale);

}  // namespace rigor
