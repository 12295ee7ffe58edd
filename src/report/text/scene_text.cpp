// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/utf8.h"
#include "scene/quantity/quantity_dimension.h"

namespace rigor {
namespace {

constexpr std::size_t name_width = 24;
constexpr std::size_t shown_rows = 5;  // of a motion; a picture or JSON has all

std::string in_column(const std::string& text, std::size_t width) {
  const std::string shown = printable(text);
  const std::size_t used = cells(shown);
  return shown + std::string(used < width ? width - used : 1, ' ');
}

/// Ten digits: more than a body's data have.
std::string number(double value) { return fmt::format("{:.10g}", value == 0 ? 0.0 : value); }

/// As many as it takes to read the same double again: for a number with a bound of its error.
std::string all_digits(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }

std::string tuple(const std::vector<double>& values, std::size_t from, std::size_t count,
                  std::string (*digits)(double) = number) {
  if (count == 1) return digits(values[from]);
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "(" : ", ") + digits(values[from + i]);
  return text + ")";
}

/// With two digits, and never less.
std::string rounded_up(double bound) {
  const std::string nearest = fmt::format("{:.1e}", bound);
  double printed = 0;
  std::from_chars(nearest.data(), nearest.data() + nearest.size(), printed);
  if (printed >= bound) return nearest;
  return fmt::format("{:.1e}", bound + 0.5 * std::pow(10, std::floor(std::log10(bound)) - 1));
}

std::string print_error(const SceneQuantity& quantity) {
  const double worst = std::ranges::max(quantity.error);
  if (!std::isfinite(worst)) return "no bound of the rounding errors is known";
  if (worst == 0) return "exactly";
  const char* open = has_open_sign(quantity) ? ": its sign cannot be told from these numbers" : "";
  return "rounding errors are at most " + rounded_up(worst) + open;
}

std::string unit_of(const SceneQuantity& quantity) {
  if (!quantity.dimension || quantity.dimension->is_none()) return {};
  return " " + si_unit(*quantity.dimension);
}

std::string print_quantity(const SceneQuantity& quantity) {
  const std::size_t row = quantity.axes >= 2 ? 3 : quantity.value.size();
  std::string text;
  for (std::size_t from = 0; from < quantity.value.size(); from += row) {
    text += "  " + in_column(from == 0 ? quantity.source : "", name_width) +
            tuple(quantity.value, from, row, quantity.error.empty() ? number : all_digits);
    if (from == 0) text += unit_of(quantity);
    text += '\n';
  }
  if (quantity.error.empty()) return text;
  return text + "  " + in_column("", name_width) + print_error(quantity) + '\n';
}

std::string print_rows(const SceneQuantity& quantity, const Motion& motion) {
  std::string text;
  const std::size_t count = std::min(quantity.rows.size(), shown_rows);
  for (std::size_t i = 1; i < count; ++i) {
    const std::size_t row = i * (quantity.rows.size() - 1) / (count - 1);
    text += "  " + in_column(fmt::format("    t = {} s", number(motion.times[row])), name_width) +
            tuple(quantity.rows[row], 0, quantity.rows[row].size()) + '\n';
  }
  return text;
}

std::string print_drift(const SceneDrift& drift) {
  if (std::isnan(drift.relative))
    return fmt::format("  {}is not finite all the time\n", in_column(drift.source, name_width));
  if (!drift.constant)
    return fmt::format("  {}changes by {:.1e} of its size\n", in_column(drift.source, name_width),
                       drift.relative);
  return fmt::format("  {}constant{} to {:.1e}\n", in_column(drift.source, name_width),
                     drift.in_space ? " in space" : "", drift.relative);
}

/// Half a kick, a free turn, half a kick.
std::string split_order(const Motion& motion) {
  return motion.split_order ? fmt::format(" (split, of order {:.2f})", *motion.split_order) : "";
}

std::string print_nodes(const SceneResult& result) {
  std::string text = "\ncomputed\n";
  double total = 0;
  for (const SceneNode& node : result.nodes) {
    if (!node.computed) continue;
    total += node.milliseconds;
    text += fmt::format("  {}{:>10.4f} ms  {}\n", in_column(node.name, 36), node.milliseconds,
                        printable(node.reason));
  }
  text += "not computed\n";
  for (const SceneNode& node : result.nodes) {
    if (!node.computed) text += fmt::format("  {}{}\n", in_column(node.name, 36), printable(node.reason));
  }
  const SceneCounts counts = result.counts();
  return text + fmt::format("{} computed, {} not; {:.4f} ms\n", counts.computed, counts.skipped, total);
}

}  // namespace

std::string print_scene(const SceneResult& result, const SceneTextOptions& options) {
  std::string text =
      printable(result.title) + "\n  " + in_column("body", name_width) + printable(result.body) + '\n';
  if (result.along_principal_axes)
    text += "  " + in_column("axes", name_width) + "principal axes of the body\n";
  for (const SceneQuantity& quantity : result.quantities) {
    text += print_quantity(quantity);
    if (result.motion && !quantity.rows.empty()) text += print_rows(quantity, *result.motion);
  }
  if (result.motion) {
    text += fmt::format("\nmotion: {} rows until {} s, {}\n", result.motion->times.size(),
                        number(result.motion->times.empty() ? 0 : result.motion->times.back()),
                        result.motion->closed_form
                            ? "in closed form: the equations are a free rigid body's"
                            : fmt::format("{} steps{}, {} evaluations of the rates", result.motion->steps,
                                          split_order(*result.motion), result.motion->evaluations));
    for (const SceneDrift& drift : result.drifts) text += print_drift(drift);
  }
  if (options.explain) text += print_nodes(result);
  return text;
}

}  // namespace rigor
