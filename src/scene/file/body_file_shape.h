// SPDX-License-Identifier: GPL-3.0-or-later
// The body of a table with `shape`. Keys apart from `mass`, `points` and `seed`:
//
//   rod                  length                       along z
//   hoop, disc           radius, or radii of two      around z
//   plate                size of two                  across z
//   box                  size of three
//   sphere, spherical shell   radius
//   ellipsoid            radii of three
//   cylinder, cone       radius, or radii of two; height     along z, the cone's apex up
#pragma once

#include <optional>
#include <string>

#include "numeric/body/body.h"
#include "scene/file/toml_reader.h"

namespace rigor {

[[nodiscard]] std::optional<Body> read_shape(TomlReader& reader, std::string name);

/// A quantity that must be there and be positive.
[[nodiscard]] std::optional<double> read_positive(TomlReader& reader, std::string_view key,
                                                  const Dimension& dimension);

/// The value of a result; its reason becomes a diagnostic at `span`.
template <class T>
[[nodiscard]] std::optional<T> value_or_report(Result<T> result, DiagnosticKind kind, Span span,
                                               Diagnostics& diagnostics) {
  if (result) return std::move(*result);
  diagnostics.push_back({kind, span, std::move(result.error().reason)});
  return std::nullopt;
}

}  // namespace rigor
