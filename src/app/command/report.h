// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor report`: notes with their verdicts as a page and as a LaTeX document.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

/// Writes what is asked for; `-` is `out`. The code is that of `rigor check`, or no_input if a file cannot be
/// read or written.
[[nodiscard]] ExitCode write_reports(const ReportCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
