// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "check/step/report.h"

namespace rigor {

/// What the formats for programs that run checks need apart from the report.
struct CheckFormat {
  bool strict = false;      // warnings are wrong
  std::string folder = {};  // paths inside it are said from there; empty: as they are
};

}  // namespace rigor
