// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/stability_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/utf8.h"

namespace rigor {
namespace {

/// A cell must not end its row.
std::string latex_cell(const std::string& text) {
  std::string safe;
  for (const char each : printable(text)) safe += each == '|' ? std::string("\\|") : std::string(1, each);
  return safe;
}

std::string table_number(double value) {
  if (std::isnan(value)) return "none";
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

std::string table_row(const std::string& body, const StabilityMeasurement& axis) {
  const std::string start = fmt::format("| {} | {} | ", latex_cell(body), axis.axis + 1);
  if (axis.points.empty()) return start + fmt::format("{} | | | | |\n", latex_cell(axis.problem));
  const StabilityPoint& last = axis.points.back();
  const std::string order = std::isnan(axis.order) ? "exact" : fmt::format("{:.2f}", axis.order);
  return start + fmt::format("{} | {} | {} | {:.1e} | {} |\n", name_of(axis.fate),
                             table_number(axis.predicted), table_number(last.measured), last.error,
                             axis.problem.empty() ? order : latex_cell(axis.problem));
}

struct Kind {
  SpinFate fate;
  Mark mark;
};
constexpr std::array kinds{Kind{SpinFate::oscillates, Mark::circle}, Kind{SpinFate::grows, Mark::triangle},
                           Kind{SpinFate::neither, Mark::cross}};

}  // namespace

std::string stability_table(std::span<const BodyStability> bodies) {
  std::string text =
      "| body | axis | the push | Ω² of the notes (1/s²) | measured | error | falls with the push to the "
      "power |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const BodyStability& body : bodies) {
    for (const StabilityMeasurement& axis : body.axes) text += table_row(body.body, axis);
    if (body.axes.empty() && !body.diagnostics.empty()) {
      text += fmt::format("| {} | | {} | | | | |\n", latex_cell(body.body),
                          latex_cell(body.diagnostics[0].message));
    }
  }
  return text;
}

Plot stability_plot(std::span<const BodyStability> bodies) {
  Plot plot{"The notes' Ω² against the motion",
            {"push across the spin, over the spin", true},
            {"error of Ω², relative", true},
            {}};
  double low = INFINITY;
  double high = 0;
  double level = 0;  // the greatest error over the push squared
  for (const Kind& kind : kinds) {
    PlotSeries series{std::string(name_of(kind.fate)), {}, kind.mark, Stroke::none};
    for (const BodyStability& body : bodies) {
      for (const StabilityMeasurement& axis : body.axes) {
        if (axis.fate != kind.fate) continue;
        for (const StabilityPoint& point : axis.points) {
          series.points.push_back({point.push, point.error});
          low = std::min(low, point.push);
          high = std::max(high, point.push);
          if (std::isfinite(point.error)) level = std::max(level, point.error / (point.push * point.push));
        }
      }
    }
    if (!series.points.empty()) plot.series.push_back(std::move(series));
  }
  if (low < high && level > 0) {
    plot.series.push_back({"as the square of the push",
                           {{low, level * low * low}, {high, level * high * high}},
                           Mark::none,
                           Stroke::dashed});
  }
  return plot;
}

}  // namespace rigor
