// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor explain`: the small steps between the forms of a chain.
#pragma once

#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

/// The code: wrong if something is refuted that was not expected to be, or a place is unknown; open if a step
/// has a gap; ok if all steps are explained. What is no file and has a relation in it is a statement.
[[nodiscard]] ExitCode explain_chains(const ExplainCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
