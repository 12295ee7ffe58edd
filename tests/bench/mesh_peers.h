// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over a mesh as they are found in programs.
#pragma once

#include "numeric/kernels/mesh_families.h"

namespace rigor {

/// D. Eberly, "Polyhedral Mass Properties (Revisited)", 2002, section 2.4: Gauss's theorem with common
/// subexpressions.
[[nodiscard]] PlainMeshSums eberly_mesh_sums(const Mesh& mesh);

/// Σ det/120 (…) from the vertices' mean.
[[nodiscard]] PlainMeshSums mean_mesh_sums(const Mesh& mesh);

/// The same about the origin, without a difference for each corner.
[[nodiscard]] PlainMeshSums origin_mesh_sums(const Mesh& mesh);

}  // namespace rigor
