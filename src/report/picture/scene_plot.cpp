// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/scene_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/quantity/quantity_dimension.h"

namespace rigor {
namespace {

/// Of Σ I ω², relative.
constexpr double most_off_surface = 1e-6;

constexpr std::array strokes{Stroke::solid, Stroke::dashed, Stroke::dotted};

std::string component_name(std::size_t component, int axes) {
  if (axes == 0) return {};
  if (axes == 1) return fmt::format("component {}", component + 1);
  return fmt::format("component {}{}", component / 3 + 1, component % 3 + 1);
}

/// `kg m^2/s` with raised digits.
std::string unit_label(const std::string& unit) {
  std::string label;
  bool raised = false;
  for (const char each : unit) {
    raised = each == '^' || (raised && each >= '0' && each <= '9');
    if (each == '^') continue;
    label += raised ? fmt::format("$^{}$", each) : std::string(1, each);
  }
  return label;
}

Plot plot_of(const SceneResult& result, const SceneQuantity& quantity) {
  const std::string name = plain_name(quantity.source);
  Plot plot{fmt::format("{}: {}", result.title, name), {"time (s)"}, {name}, {}};
  if (quantity.dimension && !quantity.dimension->is_none()) {
    plot.y.label += " (" + unit_label(si_unit(*quantity.dimension)) + ")";
  }
  for (std::size_t c = 0; c < quantity.value.size(); ++c) {
    PlotSeries series{component_name(c, quantity.axes), {}, Mark::none, strokes[c % strokes.size()]};
    for (std::size_t row = 0; row < quantity.rows.size(); ++row) {
      series.points.push_back({result.motion->times[row], quantity.rows[row][c]});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::string plain_name(const std::string& source) {
  std::string name = source;
  while (name.ends_with(' ')) name.pop_back();
  if (name.ends_with("(t)")) name.resize(name.size() - 3);
  return "$" + name + "$";
}

std::vector<Plot> plots_of(const SceneResult& result) {
  std::vector<Plot> plots;
  for (const SceneQuantity& quantity : result.quantities) {
    if (result.motion && !quantity.rows.empty()) plots.push_back(plot_of(result, quantity));
  }
  return plots;
}

std::vector<EllipsoidPlot> spin_paths_of(const SceneResult& result) {
  if (!result.motion || !result.moments || result.motion->spins.empty()) return {};
  const auto& moments = *result.moments;
  if (std::ranges::min(moments) <= 0) return {};
  const Vector3& first = result.motion->spins[0];
  double energy = 0;
  for (std::size_t i = 0; i < 3; ++i) energy += moments[i] * first[i] * first[i];
  if (!(energy > 0)) return {};
  for (const Vector3& spin : result.motion->spins) {  // with a torque the path leaves the ellipsoid
    double there = 0;
    for (std::size_t i = 0; i < 3; ++i) there += moments[i] * spin[i] * spin[i];
    if (!(std::abs(there - energy) <= most_off_surface * energy)) return {};
  }
  EllipsoidPlot plot{.title = result.title + ": path of the spin on the inertia ellipsoid",
                     .names = {"axis 1", "axis 2", "axis 3"}};
  for (std::size_t i = 0; i < 3; ++i) plot.half_axes[i] = std::sqrt(energy / moments[i]);
  plot.paths.push_back({fmt::format("the spin, in the body, for {:.6g} s", result.motion->times.back()),
                        result.motion->spins});
  return {plot};
}

}  // namespace rigor
