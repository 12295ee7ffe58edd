// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/lane_kernels.h"
#include "numeric/run/run_steps.h"

namespace rigor {

namespace baseline {
extern const FindStep find_step;
}
#ifdef RIGOR_X86_64_LEVELS
namespace x86_64_v3 {
extern const FindStep find_step;
}
namespace x86_64_v4 {
extern const FindStep find_step;
}
#endif

FindStep steps_of(std::string_view instruction_set) {
#ifdef RIGOR_X86_64_LEVELS
  if (instruction_set == "x86_64_v4") return x86_64_v4::find_step;
  if (instruction_set == "x86_64_v3") return x86_64_v3::find_step;
#endif
  static_cast<void>(instruction_set);
  return baseline::find_step;
}

FindStep wide_steps() {
  static const FindStep chosen = steps_of(lane_kernels().instruction_set);
  return chosen;
}

}  // namespace rigor
