// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/lane_kernels.h"

#include <cstdlib>

namespace rigor {

namespace baseline {
extern const LaneKernels kernels;
}
#ifdef RIGOR_X86_64_LEVELS
namespace x86_64_v3 {
extern const LaneKernels kernels;
}
namespace x86_64_v4 {
extern const LaneKernels kernels;
}
#endif

const std::vector<const LaneKernels*>& runnable_lane_kernels() {
  static const std::vector<const LaneKernels*> runnable = [] {
    std::vector<const LaneKernels*> sets = {&baseline::kernels};
#ifdef RIGOR_X86_64_LEVELS
    if (__builtin_cpu_supports("x86-64-v3")) sets.push_back(&x86_64_v3::kernels);
    if (__builtin_cpu_supports("x86-64-v4")) sets.push_back(&x86_64_v4::kernels);
#endif
    return sets;
  }();
  return runnable;
}

const LaneKernels& lane_kernels_named(std::string_view instruction_set) {
  const auto& sets = runnable_lane_kernels();
  for (const LaneKernels* kernels : sets)
    if (kernels->instruction_set == instruction_set) return *kernels;
  return *sets.back();
}

const LaneKernels& lane_kernels() {
  static const LaneKernels& chosen = []() -> const LaneKernels& {
    const char* name = std::getenv("RIGOR_INSTRUCTION_SET");
    return lane_kernels_named(name == nullptr ? "" : name);
  }();
  return chosen;
}

}  // namespace rigor
