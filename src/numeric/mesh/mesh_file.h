// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles from the bytes of an STL or OBJ file.
#pragma once

#include <string_view>

#include "numeric/mesh/mesh.h"

namespace rigor {

/// Binary if the size is what the count of triangles in it says, else ASCII if it begins with `solid`.
/// Normals and attributes are ignored. The reason names the line or the triangle (from 1).
[[nodiscard]] Result<Mesh> read_stl(std::string_view bytes);

/// Vertices and faces of a Wavefront OBJ file; texture, normals, groups, lines and materials are ignored, and
/// an unknown statement is an error. A face of n > 3 corners becomes a fan from its first corner. Negative
/// indices count back from the last vertex.
[[nodiscard]] Result<Mesh> read_obj(std::string_view bytes);

/// By the ending of the file's name, `.stl` or `.obj`, in any case.
[[nodiscard]] Result<Mesh> read_mesh(std::string_view file_name, std::string_view bytes);

}  // namespace rigor
