// SPDX-License-Identifier: GPL-3.0-or-later
// The notes against nature: a table and a picture of measured stability.
#pragma once

#include <span>
#include <string>

#include "report/picture/plot.h"
#include "scene/scene_functions.h"

namespace rigor {

/// A Markdown table, a row for each body and axis: Ω² by the notes and as it was measured with the smallest
/// push, the error there, and how the error falls with the push; then a row for each body that gave nothing,
/// and why.
[[nodiscard]] std::string stability_table(std::span<const BodyStability> bodies);

/// Error against push, both logarithmic; points of one kind of motion are one series, next to a line of slope
/// 2.
[[nodiscard]] Plot stability_plot(std::span<const BodyStability> bodies);

}  // namespace rigor
