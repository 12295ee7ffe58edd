// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/grammar/words.h"

namespace rigor {

/// The manual page of section 1, for `man`: each command with its options and examples, and the exit codes.
/// Between back-ticks stands what is typed; it is set in bold.
[[nodiscard]] std::string manual_page(const ProgramWords& program);

}  // namespace rigor
