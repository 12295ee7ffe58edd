// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/body_file_shape.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "numeric/body/shapes.h"
#include "scene/file/quantity_text.h"
#include "source/suggest.h"

namespace rigor {
namespace {

constexpr std::string_view cloud_name = "random cloud";

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const ShapeInfo& kind : shape_table()) names.emplace_back(kind.name);
  names.emplace_back(cloud_name);
  return names;
}

bool is_positive(double value, const TomlValue& at, std::string_view key, Diagnostics& diagnostics) {
  if (value > 0) return true;
  diagnostics.push_back(
      {DiagnosticKind::bad_body, at.span, fmt::format("`{}` is {}, but must be positive", key, value)});
  return false;
}

/// Lengths that must be there and be positive, times `factor`.
std::optional<std::vector<double>> read_lengths(TomlReader& reader, std::string_view key, std::size_t count,
                                                double factor) {
  const TomlValue* value = reader.require(key);
  if (value == nullptr) return std::nullopt;
  auto lengths = quantities_of(*value, key, length_dimension(), count, reader.diagnostics());
  if (!lengths) return std::nullopt;
  for (std::size_t k = 0; k < count; ++k) {
    double& length = (*lengths)[k];
    if (!is_positive(length, value->items[k], key, reader.diagnostics())) return std::nullopt;
    length *= factor;
  }
  return lengths;
}

/// `radius`, or `radii` of two.
std::optional<std::vector<double>> read_radii(TomlReader& reader) {
  if (!reader.has("radius") && reader.has("radii")) return read_lengths(reader, "radii", 2, 1);
  const auto radius = read_positive(reader, "radius", length_dimension());
  if (!radius) return std::nullopt;
  return std::vector<double>{*radius, *radius};
}

/// `radius` or `radii`, then `height`.
std::optional<std::vector<double>> read_column(TomlReader& reader, double factor) {
  auto extents = read_radii(reader);
  const auto height = read_positive(reader, "height", length_dimension());
  if (!extents || !height) return std::nullopt;
  extents->push_back(*height * factor);
  return extents;
}

/// As `Shape::extents` has them; two are along x and y.
std::optional<std::vector<double>> read_extents(TomlReader& reader, ShapeKind kind) {
  switch (kind) {
    case ShapeKind::rod: {
      const auto length = read_positive(reader, "length", length_dimension());
      if (!length) return std::nullopt;
      return std::vector<double>{0, 0, *length / 2};
    }
    case ShapeKind::hoop:
    case ShapeKind::disc:
      return read_radii(reader);
    case ShapeKind::plate:
      return read_lengths(reader, "size", 2, 0.5);
    case ShapeKind::box:
      return read_lengths(reader, "size", 3, 0.5);
    case ShapeKind::sphere:
    case ShapeKind::shell: {
      const auto radius = read_positive(reader, "radius", length_dimension());
      if (!radius) return std::nullopt;
      return std::vector<double>{*radius, *radius, *radius};
    }
    case ShapeKind::ellipsoid:
      return read_lengths(reader, "radii", 3, 1);
    case ShapeKind::cylinder:
      return read_column(reader, 0.5);
    case ShapeKind::cone:
      return read_column(reader, 1);
  }
  return std::nullopt;
}

/// `points`; false where it is there and wrong.
bool read_points(TomlReader& reader, std::size_t& points) {
  if (!reader.has("points")) return true;
  const auto count = reader.whole("points");
  if (!count) return false;
  if (*count < 1 || *count > static_cast<std::int64_t>(most_particles)) {
    reader.diagnostics().push_back(
        {DiagnosticKind::bad_body, reader.find("points")->span,
         fmt::format("`points` is {}, but must be from 1 to {}", *count, most_particles)});
    return false;
  }
  points = static_cast<std::size_t>(*count);
  return true;
}

bool read_seed(TomlReader& reader, std::uint64_t& seed) {
  if (!reader.has("seed")) return true;
  const auto whole = reader.whole("seed");
  if (!whole) return false;
  seed = static_cast<std::uint64_t>(*whole);
  return true;
}

std::optional<Body> read_cloud(TomlReader& reader, std::string name) {
  std::size_t points = 0;
  std::uint64_t seed = 1;
  const bool has_points = reader.require("points") != nullptr && read_points(reader, points);
  if (!read_seed(reader, seed) || !has_points) return std::nullopt;
  return value_or_report(random_cloud(std::move(name), points, seed), DiagnosticKind::bad_body,
                         reader.span_of("shape"), reader.diagnostics());
}

std::optional<Body> body_of(TomlReader& reader, std::string name, const ShapeInfo& kind) {
  const auto mass = read_positive(reader, "mass", mass_dimension());
  const auto extents = read_extents(reader, kind.kind);
  std::size_t points = 0;
  std::uint64_t seed = 1;
  const bool has_points = read_points(reader, points);
  const bool has_seed = read_seed(reader, seed);
  if (!has_points || !has_seed || !mass || !extents) return std::nullopt;
  Shape shape{kind.kind, *mass, {}};
  std::copy(extents->begin(), extents->end(), shape.extents.begin());
  return value_or_report(points > 0 ? sampled_body(std::move(name), shape, points, seed)
                                    : quadrature_body(std::move(name), shape),
                         DiagnosticKind::bad_body, reader.span_of("shape"), reader.diagnostics());
}

}  // namespace

std::optional<double> read_positive(TomlReader& reader, std::string_view key, const Dimension& dimension) {
  const TomlValue* value = reader.require(key);
  if (value == nullptr) return std::nullopt;
  const auto quantity = quantity_of(*value, key, dimension, reader.diagnostics());
  if (!quantity || !is_positive(*quantity, *value, key, reader.diagnostics())) return std::nullopt;
  return quantity;
}

std::optional<Body> read_shape(TomlReader& reader, std::string name) {
  const auto asked = reader.text("shape");
  if (!asked) {
    reader.accept_all();
    return std::nullopt;
  }
  if (*asked == cloud_name) return read_cloud(reader, std::move(name));
  for (const ShapeInfo& kind : shape_table()) {
    if (kind.name == *asked) return body_of(reader, std::move(name), kind);
  }
  reader.accept_all();
  const std::vector<std::string> names = shape_names();
  const auto near = suggest(*asked, names);
  reader.diagnostics().push_back({DiagnosticKind::bad_body,
                                  reader.find("shape")->span,
                                  fmt::format("`{}` is not a known shape", *asked),
                                  {},
                                  {near ? fmt::format("did you mean `{}`?", *near)
                                        : fmt::format("the shapes are {}", fmt::join(names, ", "))}});
  return std::nullopt;
}

}  // namespace rigor
