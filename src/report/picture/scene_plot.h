// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a scene: what was asked over the time, one plot a quantity; and the path of the spin on the
// body's inertia ellipsoid.
#pragma once

#include <string>
#include <vector>

#include "report/picture/plot.h"
#include "report/picture/plot_ellipsoid.h"
#include "scene/quantity/scene.h"

namespace rigor {

/// Empty where nothing was asked over the time.
[[nodiscard]] std::vector<Plot> plots_of(const SceneResult& result);

/// The ellipsoid I₁ω₁² + I₂ω₂² + I₃ω₃² = const through the first spin, with half axes ∝ 1/√I. Nothing without
/// a motion, where a moment is not known or 0, or where the sum changes by more than 1e-6 of itself.
[[nodiscard]] std::vector<EllipsoidPlot> spin_paths_of(const SceneResult& result);

/// `\boldsymbol{\omega}(t)` becomes `$\boldsymbol{\omega}$`.
[[nodiscard]] std::string plain_name(const std::string& source);

}  // namespace rigor
