// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "check/step/report.h"

namespace rigor {

/// A diagnostic of a file and the step it belongs to, if it belongs to one.
struct PlacedDiagnostic {
  const Diagnostic* diagnostic = nullptr;
  const Step* step = nullptr;
};

/// All diagnostics of a file's steps and of the file itself, in the order of their places; at one place,
/// those of steps first, in their order. A diagnostic of several steps in the same words is listed once.
[[nodiscard]] std::vector<PlacedDiagnostic> diagnostics_of(const FileReport& file);

}  // namespace rigor
