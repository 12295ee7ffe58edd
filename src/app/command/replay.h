// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor replay REPORT.json`: puts the samples of a report into the notes that it was made from.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

/// The exit code. Paths in the report are those of the working directory; a relative one that is not there is
/// looked for next to the report.
[[nodiscard]] ExitCode replay(const ReplayCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
