// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/body_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

#include "base/among.h"
#include "numeric/body/bodies.h"
#include "numeric/mesh/cloud_file.h"
#include "numeric/mesh/mesh.h"
#include "numeric/mesh/mesh_file.h"
#include "scene/file/body_file_shape.h"
#include "scene/file/quantity_text.h"
#include "scene/file/toml_reader.h"
#include "source/read_file.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kinds{"shape",   "particles", "mesh", "cloud",
                                                "moments", "inertia",   "parts"};

std::optional<Position> position_of(std::optional<std::vector<double>> values) {
  if (!values) return std::nullopt;
  return Position{(*values)[0], (*values)[1], (*values)[2]};
}

/// Puts the file's name before a reason.
auto naming(const std::string& file) {
  return [&file](const Error& error) { return Error{fmt::format("`{}`: {}", file, error.reason)}; };
}

/// Reads one table; parts recurse, no deeper than `parse_toml` lets tables nest.
class BodyReader {
 public:
  BodyReader(const TomlValue& table, std::string name, const fs::path& folder, Diagnostics& diagnostics)
      : reader_(table, "the body", diagnostics),
        name_(std::move(name)),
        folder_(folder),
        diagnostics_(diagnostics) {}

  /// `offset`: of a part; null: it is not one.
  std::optional<Body> read(Position* offset) {
    const std::size_t before = diagnostics_.size();
    const std::string title = reader_.text("title").value_or("");
    if (offset != nullptr && reader_.has("offset")) {
      if (const auto at = position_of(reader_.quantities("offset", length_dimension(), 3))) *offset = *at;
    }
    const std::size_t axis = read_axis();
    const auto kind = kind_of();
    if (!kind) return std::nullopt;
    auto body = read_kind(*kind);
    reader_.report_unknown();
    if (!body || diagnostics_.size() > before) return std::nullopt;
    body->title = title;
    return along_axis(std::move(*body), axis);
  }

 private:
  void report(DiagnosticKind kind, Span span, std::string message) {
    diagnostics_.push_back({kind, span, std::move(message)});
  }

  std::optional<std::string_view> kind_of() {
    std::optional<std::string_view> found;
    for (const std::string_view kind : kinds) {
      if (!reader_.has(kind)) continue;
      if (found) {
        report(DiagnosticKind::bad_body, reader_.span_of(kind),
               fmt::format("the body has both `{}` and `{}`", *found, kind));
        return std::nullopt;
      }
      found = kind;
    }
    if (found) return found;
    reader_.report_unknown();  // perhaps a slip of the pen in one of them
    report(DiagnosticKind::bad_body, reader_.table().span,
           fmt::format("the body has none of the keys `{}`", fmt::join(kinds, "`, `")));
    return std::nullopt;
  }

  std::size_t read_axis() {
    const auto along = reader_.text("along");
    if (!along) return 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (*along == std::string_view("xyz").substr(axis, 1)) return axis;
    }
    report(DiagnosticKind::bad_body, reader_.find("along")->span,
           fmt::format("`{}` is not an axis: `along` must be `x`, `y` or `z`", *along));
    return 2;
  }

  std::optional<Body> read_kind(std::string_view kind) {
    if (kind == "shape") return read_shape(reader_, name_);
    if (kind == "particles") return read_particles();
    if (kind == "mesh") return read_mesh_file();
    if (kind == "cloud") return read_cloud_file();
    if (kind == "parts") return read_parts();
    return read_inertia(kind);
  }

  std::optional<Body> read_particles() {
    const auto* items = reader_.array("particles");
    if (items == nullptr) return std::nullopt;
    std::vector<double> masses;
    std::vector<Position> positions;
    bool is_good = true;
    for (const TomlValue& item : *items) {
      if (!is_table(item, "particles", diagnostics_)) return std::nullopt;
      TomlReader particle(item, "the particle", diagnostics_);
      const auto mass = read_particle_mass(particle);
      const auto position = read_place(particle);
      particle.report_unknown();
      is_good = is_good && mass && position;
      masses.push_back(mass.value_or(1));
      positions.push_back(position.value_or(Position{}));
    }
    if (!is_good) return std::nullopt;
    return value_or_report(point_masses(name_, masses, positions), DiagnosticKind::bad_body,
                           reader_.span_of("particles"), diagnostics_);
  }

  std::optional<double> read_particle_mass(TomlReader& particle) {
    const TomlValue* value = particle.require("mass");
    if (value == nullptr) return std::nullopt;
    const auto mass = quantity_of(*value, "mass", mass_dimension(), diagnostics_);
    if (!mass || *mass >= 0) return mass;
    report(DiagnosticKind::bad_body, value->span,
           fmt::format("`mass` is {}, but must not be negative", *mass));
    return std::nullopt;
  }

  /// `position`, or spherical coordinates: `polar` is the angle to the z axis.
  std::optional<Position> read_place(TomlReader& particle) {
    if (!particle.has("distance")) {
      if (particle.require("position") == nullptr) return std::nullopt;
      return position_of(particle.quantities("position", length_dimension(), 3));
    }
    const auto distance = particle.quantity("distance", length_dimension());
    const auto polar = read_angle(particle, "polar");
    const auto azimuth = read_angle(particle, "azimuth");
    if (!distance || !polar || !azimuth) return std::nullopt;
    return Position{*distance * std::sin(*polar) * std::cos(*azimuth),
                    *distance * std::sin(*polar) * std::sin(*azimuth), *distance * std::cos(*polar)};
  }

  static std::optional<double> read_angle(TomlReader& particle, std::string_view key) {
    return particle.has(key) ? particle.quantity(key, Dimension()) : 0;
  }

  std::optional<Body> read_mesh_file() {
    const auto file = reader_.text("mesh");
    const auto unit = reader_.has("unit") ? read_positive(reader_, "unit", length_dimension()) : 1;
    const bool has_density = reader_.has("density");
    if (has_density && reader_.has("mass")) {
      report(DiagnosticKind::bad_body, reader_.span_of("density"), "the body has both `mass` and `density`");
      return std::nullopt;
    }
    const auto amount = has_density ? read_positive(reader_, "density", density_dimension())
                                    : read_positive(reader_, "mass", mass_dimension());
    if (!file || !unit || !amount) return std::nullopt;
    const Span span = reader_.find("mesh")->span;
    const auto in_metres = [&](const MeshMass& found) {
      return *unit == 1 ? Result<MeshMass>(found) : in_unit(found, *unit);
    };
    const auto measured = mesh_in(*file).and_then([&](const Mesh& mesh) {
      return mesh_mass(mesh, MeshSharpness::always).and_then(in_metres).map_error(naming(*file));
    });
    const auto enclosed = value_or_report(measured, DiagnosticKind::bad_mesh, span, diagnostics_);
    if (!enclosed) return std::nullopt;
    return value_or_report(
        has_density ? mesh_body_of_density(name_, *enclosed, *amount) : mesh_body(name_, *enclosed, *amount),
        DiagnosticKind::bad_body, span, diagnostics_);
  }

  [[nodiscard]] Result<std::string> path_in_folder(const std::string& file) const {
    const fs::path path(file);
    if (path.is_absolute() || is_one_of("..", path))
      return refuse(fmt::format("`{}` is not in the folder of the body's file", file));
    return (folder_ / path).string();
  }

  [[nodiscard]] Result<Mesh> mesh_in(const std::string& file) const {
    const auto path = path_in_folder(file);
    if (!path) return tl::unexpected(path.error());
    return read_file(*path)
        .and_then([&](const std::string& bytes) { return read_mesh(file, bytes); })
        .map_error(naming(file));
  }

  std::optional<Body> read_cloud_file() {
    const auto file = reader_.text("cloud");
    const auto unit = reader_.has("unit") ? read_positive(reader_, "unit", length_dimension()) : 1;
    if (!file || !unit) return std::nullopt;
    const Span span = reader_.find("cloud")->span;
    const auto path = value_or_report(path_in_folder(*file), DiagnosticKind::bad_cloud, span, diagnostics_);
    if (!path) return std::nullopt;
    return value_or_report(read_cloud(name_, *path, *unit).map_error(naming(*file)),
                           DiagnosticKind::bad_cloud, span, diagnostics_);
  }

  std::optional<Body> read_inertia(std::string_view kind) {
    const auto mass = read_positive(reader_, "mass", mass_dimension());
    InertiaTensor inertia{};
    if (kind == "moments") {
      const auto moments = position_of(reader_.quantities("moments", inertia_dimension(), 3));
      if (!mass || !moments) return std::nullopt;
      for (std::size_t k = 0; k < 3; ++k) inertia[k][k] = (*moments)[k];
      if (const auto checked = check_moments(*moments); !checked) {
        report(DiagnosticKind::bad_body, reader_.span_of(kind), checked.error().reason);
        return std::nullopt;
      }
    } else if (!read_tensor(inertia) || !mass) {
      return std::nullopt;
    }
    return value_or_report(body_with_inertia(name_, *mass, inertia), DiagnosticKind::bad_body,
                           reader_.span_of(kind), diagnostics_);
  }

  bool read_tensor(InertiaTensor& inertia) {
    const auto* rows = reader_.array("inertia");
    if (rows == nullptr) return false;
    if (rows->size() != 3) {
      report(DiagnosticKind::bad_toml, reader_.find("inertia")->span,
             fmt::format("`inertia` has {} rows, but must have 3", rows->size()));
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row =
          position_of(quantities_of((*rows)[i], "inertia", inertia_dimension(), 3, diagnostics_));
      if (!row) return false;
      inertia[i] = *row;
    }
    return true;
  }

  std::optional<Body> read_parts() {
    const auto* items = reader_.array("parts");
    if (items == nullptr) return std::nullopt;
    std::vector<PlacedBody> parts;
    std::size_t particles = 0;
    bool is_good = true;
    for (const TomlValue& item : *items) {
      if (!is_table(item, "parts", diagnostics_)) return std::nullopt;
      Position offset{};
      auto part = BodyReader(item, name_, folder_, diagnostics_).read(&offset);
      is_good = is_good && part;
      if (!is_good) continue;
      particles += part->size();
      if (particles > most_particles) {  // before all of them are in memory
        report(
            DiagnosticKind::bad_body, item.span,
            fmt::format("the parts up to this one have {} particles, at most {}", particles, most_particles));
        return std::nullopt;
      }
      parts.push_back({std::move(*part), offset});
    }
    if (!is_good) return std::nullopt;
    return value_or_report(joined(name_, std::move(parts)), DiagnosticKind::bad_body,
                           reader_.span_of("parts"), diagnostics_);
  }

  TomlReader reader_;
  std::string name_;
  const fs::path& folder_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Body> read_body(const TomlValue& table, std::string name, const fs::path& folder,
                              Diagnostics& diagnostics) {
  return BodyReader(table, std::move(name), folder, diagnostics).read(nullptr);
}

std::optional<Body> read_body_file(const std::string& path, SourceMap& sources, Diagnostics& diagnostics) {
  auto text = read_file(path);
  if (!text) {
    const FileId file = sources.add(path, "");
    diagnostics.push_back({DiagnosticKind::unreadable_file, {file, 0, 0}, text.error().reason});
    return std::nullopt;
  }
  Diagnostics mended = mend_text(*text, 0);
  const FileId file = sources.add(path, std::move(*text));
  for (Diagnostic& diagnostic : mended) diagnostic.span.file = file;
  if (!mended.empty()) {
    diagnostics.insert(diagnostics.end(), mended.begin(), mended.end());
    return std::nullopt;
  }
  const auto table = parse_toml(sources, file, diagnostics);
  if (!table) return std::nullopt;
  const fs::path place(path);
  return read_body(*table, place.stem().string(), place.parent_path(), diagnostics);
}

}  // namespace rigor
