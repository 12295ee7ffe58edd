// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "bench_clock.h"
#include "mesh_peers.h"
#include "numeric/kernels/mesh_sums.h"

namespace rigor {
namespace {

struct MeshMethod {
  std::string name;
  std::function<PlainMeshSums(const Mesh&)> sums;
};

/// A failure has no volume.
PlainMeshSums rounded(const Result<MeshMoments>& moments) {
  PlainMeshSums sums;
  if (!moments) return sums;
  sums.volume = moments->volume.high;
  for (std::size_t i = 0; i < 3; ++i) {
    sums.centre[i] = moments->centre[i].high;
    for (std::size_t j = 0; j < 3; ++j) sums.second[i][j] = moments->second_moments[i][j].high;
  }
  return sums;
}

std::vector<MeshMethod> mesh_methods() {
  const auto kernel = [](const LaneKernels& lanes, MeshSharpness sharpness) {
    return [&lanes, sharpness](const Mesh& mesh) {
      return rounded(mesh_moments(mesh.vertices, mesh.triangles, sharpness, lanes));
    };
  };
  std::vector<MeshMethod> methods{{"tetrahedra from the origin", origin_mesh_sums},
                                  {"tetrahedra from the mean", mean_mesh_sums},
                                  {"Eberly 2002", eberly_mesh_sums}};
  methods.push_back({"kernel", kernel(lane_kernels(), MeshSharpness::if_needed)});
  methods.push_back({"kernel, always sharp", kernel(lane_kernels(), MeshSharpness::always)});
  for (const LaneKernels* lanes : runnable_lane_kernels()) {
    if (lanes != &lane_kernels())
      methods.push_back(
          {fmt::format("kernel, {}", lanes->instruction_set), kernel(*lanes, MeshSharpness::if_needed)});
  }
  return methods;
}

/// Nothing is infinite or not a number, the volume has its sign, and the second moments are positive.
bool is_possible(const MeshReference& exact, const PlainMeshSums& sums) {
  if (!std::isfinite(sums.volume) || !(exact.volume * sums.volume > 0)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(sums.centre[i]) || !(sums.second[i][i] > 0)) return false;
    for (std::size_t j = 0; j < 3; ++j)
      if (!std::isfinite(sums.second[i][j])) return false;
  }
  return true;
}

/// In units of 2^-53; infinite for what is not possible.
MeshError error_of(const MeshReference& exact, const PlainMeshSums& sums) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return is_possible(exact, sums) ? plain_error(exact, sums)
                                  : MeshError{infinity, infinity, infinity, infinity};
}

}  // namespace

std::vector<KernelRow> mesh_rows() {
  constexpr std::size_t triangles = 20000;
  const std::vector<MeshMethod> methods = mesh_methods();
  std::vector<KernelRow> rows;
  for (const MeshFamily& family : mesh_families(triangles)) {
    std::vector<MeshReference> exact;
    for (const Mesh& mesh : family.meshes) exact.push_back(mesh_reference(mesh));
    for (const MeshMethod& method : methods) {
      KernelRow row{"mesh", method.name, family.name, 0, 0, ""};
      const Mesh& first = family.meshes.front();
      volatile double kept = 0;
      row.nanoseconds = least_nanoseconds([&] { kept = method.sums(first).volume; }) /
                        static_cast<double>(first.triangles.size());
      MeshError worst;
      for (std::size_t n = 0; n < exact.size(); ++n)
        worst.widen(error_of(exact[n], method.sums(family.meshes[n])));
      row.error = std::max({worst.volume, worst.centre, worst.tensor}) * 0x1p-53;
      row.remark = fmt::format("volume {:.1e}, centre {:.1e}, second moments {:.1e}", worst.volume * 0x1p-53,
                               worst.centre * 0x1p-53, worst.tensor * 0x1p-53);
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace rigor
