// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor check`: files to verdicts, in this process or in several, and verdicts to the format that was asked
// for.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

/// The exit code. Progress, `--debug` and what is the matter with a cache go to `err`.
[[nodiscard]] ExitCode check_notes(const CheckCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
