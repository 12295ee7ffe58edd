// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor eval` and `rigor bench`: the written forms of some notes in floating point.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

[[nodiscard]] ExitCode evaluate_forms(const EvalCommand& command, std::ostream& out, std::ostream& err);
[[nodiscard]] ExitCode bench_forms(const BenchCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
