// SPDX-License-Identifier: GPL-3.0-or-later
// What running a program costs, as the system counts it.
#pragma once

#include <string>
#include <vector>

namespace rigor::bench {

struct ProcessCost {
  int exit_code = -1;      // -1: it could not be started, or did not end by itself
  double elapsed = 0.0;    // milliseconds from fork to the end
  double processor = 0.0;  // milliseconds, of the user and the system
  double mebibytes = 0.0;  // largest resident set
};

/// `command[0]` is the program's path. Its output is thrown away.
[[nodiscard]] ProcessCost run_process(const std::vector<std::string>& command);

}  // namespace rigor::bench
