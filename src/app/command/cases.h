// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor cases` and `rigor case`: what test runners call, once for all steps of some notes and then for each.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

/// Checks the notes once and writes what became of each step; the code says only whether that was possible.
[[nodiscard]] ExitCode write_cases(const CasesCommand& command, std::ostream& out, std::ostream& err);

/// One of them: prints it, and its code is that of a check of this step alone.
[[nodiscard]] ExitCode tell_case(const CaseCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
