// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_written.h"

namespace rigor::bench {

namespace baseline {
extern const HandWritten loops;
}
#ifdef RIGOR_X86_64_LEVELS
namespace x86_64_v3 {
extern const HandWritten loops;
}
namespace x86_64_v4 {
extern const HandWritten loops;
}
#endif

const HandWritten& loops_for(std::string_view instruction_set) {
#ifdef RIGOR_X86_64_LEVELS
  if (instruction_set == "x86_64_v4") return x86_64_v4::loops;
  if (instruction_set == "x86_64_v3") return x86_64_v3::loops;
#endif
  static_cast<void>(instruction_set);
  return baseline::loops;
}

}  // namespace rigor::bench
