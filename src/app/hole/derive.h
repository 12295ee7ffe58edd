// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor derive`: what stands where notes, or a statement on the command line, leave a hole.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"
#include "app/grammar/exit_code.h"

namespace rigor {

/// Answers go to `out`, one a line, those of a file after their places; what has none goes to `err`.
[[nodiscard]] ExitCode derive_holes(const DeriveCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
