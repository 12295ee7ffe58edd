// SPDX-License-Identifier: GPL-3.0-or-later
// One line of the kernels' tables: what computes, on which family of inputs, how long and how wrong.
#pragma once

#include <string>

namespace rigor {

struct KernelRow {
  std::string table;
  std::string name;
  std::string family;
  double nanoseconds = 0;
  double error = 0;  // relative; infinite for a failure
  std::string remark;
};

}  // namespace rigor
