// SPDX-License-Identifier: GPL-3.0-or-later
// The connected parts of a surface. About a point far from it a small part has no volume that a sum would
// notice: so each part is summed about a point of its own, and then they are joined like bodies.
#pragma once

#include <vector>

#include "numeric/kernels/mesh_sums.h"
#include "numeric/mesh/mesh.h"

namespace rigor {

/// Two triangles are in one part if they share a vertex. Of a welded mesh; in the order of the parts' first
/// triangles. Cost: O(N), 12 ns a triangle.
[[nodiscard]] std::vector<Mesh> connected_parts(const Mesh& mesh);

/// `mesh_moments` of each, in double-double, and of all together: V = ΣV_p, c = ΣV_p c_p/V, and ∫x_i x_j dV/V
/// = ΣV_p (S_p + d_p d_p)/V about c, the d_p from the centre of the largest part, in double-double. Parts
/// whose triangles are clockwise are cavities. Error: `errors`, from those of the parts. Fails where a part
/// does, and where what is left is no body.
[[nodiscard]] Result<MeshMoments> moments_of_parts(const std::vector<Mesh>& parts);

}  // namespace rigor
