// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/sample.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "base/paint.h"
#include "base/utf8.h"

namespace rigor {
namespace {

/// How many components each of `rank` equal axes has; 0 where they do not fill that.
std::size_t components_an_axis(std::size_t count, int rank) {
  for (std::size_t each = 1; each <= count; ++each) {
    std::size_t filled = 1;
    for (int level = 0; level < rank && filled <= count; ++level) filled *= each;
    if (filled >= count) return filled == count ? each : 0;
  }
  return 0;
}

/// `(a, b, c)` around `rank` levels of brackets; components that do not fill them are listed in one level.
std::string print_components(std::span<const std::string> components, int rank) {
  if (rank <= 0 && components.size() == 1) return components.front();
  const std::size_t rows = rank <= 1 ? 0 : components_an_axis(components.size(), rank);
  if (rows == 0) return fmt::format("({})", fmt::join(components, ", "));
  const std::size_t part = components.size() / rows;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row)
    text += (row == 0 ? "" : ", ") + print_components(components.subspan(row * part, part), rank - 1);
  return fmt::format("({})", text);
}

/// `I_i` and `I_{ij}` where a sample has both; else the name alone.
std::string print_name(const Counterexample& sample, const Counterexample::Value& value) {
  constexpr std::string_view indices = "ijkl";
  const auto is_namesake = [&](const Counterexample::Value& other) {
    return other.symbol == value.symbol && other.rank != value.rank && !other.beyond;
  };
  const bool alone =
      std::ranges::none_of(sample.values, is_namesake) && std::ranges::none_of(sample.follows, is_namesake);
  const std::size_t rank = value.rank > 0 ? static_cast<std::size_t>(value.rank) : 0;
  if (alone || rank == 0 || rank > indices.size()) return printable(value.symbol);
  const std::string_view own = indices.substr(0, rank);
  return printable(value.symbol) + (rank == 1 ? fmt::format("_{}", own) : fmt::format("_{{{}}}", own));
}

/// Some values of one particle (0: of no particle).
void append_equations(const Counterexample& sample, std::span<const Counterexample::Value> values,
                      std::uint32_t particle, std::vector<std::string>& equations) {
  for (const Counterexample::Value& value : values) {
    if (value.particle != particle || value.beyond) continue;
    equations.push_back(
        fmt::format("{} = {}", print_name(sample, value), print_components(value.components, value.rank)));
  }
}

std::string print_list(const Counterexample& sample, std::span<const Counterexample::Value> values,
                       std::uint32_t particle) {
  std::vector<std::string> equations;
  append_equations(sample, values, particle, equations);
  return fmt::format("{}", fmt::join(equations, ", "));
}

/// The sample's values, and then what follows from them.
std::string print_values(const Counterexample& sample, std::uint32_t particle) {
  const std::string values = print_list(sample, sample.values, particle);
  const std::string follows = print_list(sample, sample.follows, particle);
  if (follows.empty()) return values;
  return fmt::format("{}{}hence {}", values, values.empty() ? "" : "; ", follows);
}

std::string print_sides(const Counterexample& sample) {
  std::string text = sample_component(sample);
  if (!text.empty()) text += ": ";
  if (sample.squared_distance) return text + fmt::format("|left - right|^2 is {}", sample.left);
  return text + fmt::format("left {}, right {}", sample.left, sample.right);
}

}  // namespace

std::vector<std::string> sample_equations(const Counterexample& sample, std::uint32_t particle) {
  std::vector<std::string> equations;
  append_equations(sample, sample.values, particle, equations);
  append_equations(sample, sample.follows, particle, equations);
  return equations;
}

std::string sample_component(const Counterexample& sample) {
  std::string text;
  for (const Counterexample::Axis& axis : sample.component) {
    text += text.empty() ? "component " : ", ";
    text += axis.index.empty() ? fmt::format("{}", axis.value)
                               : fmt::format("{} = {}", printable(axis.index), axis.value);
  }
  return text;
}

std::string print_sample(const Counterexample& sample, bool color) {
  const std::string head = paint("sample:", Paint::strong, color);
  std::string common = print_values(sample, 0);
  if (sample.particles == 0) {
    if (!common.empty()) common += "; ";
    return fmt::format("{} {}{}\n", head, common, print_sides(sample));
  }
  std::string text =
      fmt::format("{} {} particle{}", head, sample.particles, sample.particles == 1 ? "" : "s");
  text += common.empty() ? "\n" : fmt::format("{} {}\n", common.starts_with("hence ") ? ";" : ",", common);
  for (std::uint32_t particle = 1; particle <= sample.particles; ++particle) {
    const std::string values = print_values(sample, particle);
    if (!values.empty()) text += fmt::format("  particle {}: {}\n", particle, values);
  }
  return text + fmt::format("  {}\n", print_sides(sample));
}

}  // namespace rigor
