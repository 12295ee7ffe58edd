// SPDX-License-Identifier: GPL-3.0-or-later
// One plot in its place on a drawing.
#pragma once

#include "report/picture/plot.h"
#include "report/picture/svg.h"

namespace rigor {

inline constexpr double plot_width = 760;

/// The height that the plot needs at that width; the legend may take several rows.
[[nodiscard]] double plot_height(const Plot& plot);

/// Draws it with its upper left corner at (0, top).
void draw_plot(Svg& svg, const Plot& plot, double top);

/// One mark, about its centre.
void draw_mark(Svg& svg, Mark mark, SvgPoint centre, std::string_view colour);

}  // namespace rigor
