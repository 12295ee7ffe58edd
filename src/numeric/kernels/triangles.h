// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle mesh as data.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numeric/kernels/position.h"

namespace rigor {

/// Triangles by their corners, anticlockwise as seen from outside.
struct Mesh {
  std::vector<Position> vertices;  // m
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

}  // namespace rigor
