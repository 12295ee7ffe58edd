// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "check/step/failure_rule.h"

namespace rigor {

/// What the formats for programs that run checks need apart from the report.
struct CheckFormat {
  FailureRule rule = {};
  std::string folder = {};  // paths inside it are said from there; empty: as they are
};

}  // namespace rigor
