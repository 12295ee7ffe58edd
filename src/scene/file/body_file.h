// SPDX-License-Identifier: GPL-3.0-or-later
// Sample bodies from TOML files. Exactly one of these keys says what the body is made of:
//
//   shape = "box"            with `mass` and what the shape needs, see body_file_shape.h; eight particles or
//   so
//                            with its exact second moments, or `points` drawn from it with `seed`
//   shape = "random cloud"   with `points`, `seed`
//   particles = [{ mass = "1 kg", position = ["1 m", "0 m", "0 m"] }]      along the body's axes, or
//               [{ mass = "1 kg", distance = "1 m", polar = "30 deg", azimuth = "0 deg" }]     from the z
//               axis
//   mesh = "wedge.obj"       with `mass` or `density`, and `unit`, the length of 1 in the file, else 1 m;
//                            the path is relative to the file's folder and does not leave it
//   cloud = "dust.bin"       points with masses, see cloud_file.h, with `unit` as above; the path likewise
//   moments = [1, 2, 2.5]    with `mass`: principal moments of inertia, kg m²
//   inertia = [[…], […], […]]    with `mass`: a tensor about the centre of mass
//   parts = [{ shape = …, offset = […] }]    where `offset` is the place of the part's centre of mass
//
// `title` says in words what it is. `along = "x"` turns z into another axis (cyclically). Quantities are
// strings with a unit or numbers in SI units. The body is about its centre of mass.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "numeric/body/body.h"
#include "scene/file/toml_value.h"

namespace rigor {

/// Reads a file, which is added to the source map; the body is named after it. Nothing where something is
/// wrong, with a diagnostic for each mistake.
[[nodiscard]] std::optional<Body> read_body_file(const std::string& path, SourceMap& sources,
                                                 Diagnostics& diagnostics);

/// The same for a table of another file. `folder`: where the names of meshes and clouds start.
[[nodiscard]] std::optional<Body> read_body(const TomlValue& table, std::string name,
                                            const std::filesystem::path& folder, Diagnostics& diagnostics);

/// The path of a body: a name that contains `/` or ends in `.toml` is one; any other is looked up as
/// `name.toml` in the folders, the first first. The reason has a suggestion.
[[nodiscard]] Result<std::string> find_body(const std::string& name, const std::vector<std::string>& folders);

/// The names in the folders, in alphabetical order, each once.
[[nodiscard]] std::vector<std::string> body_names(const std::vector<std::string>& folders);

}  // namespace rigor
