// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/grammar/words.h"

namespace rigor {

/// A bash script that completes commands, options, the values of options where all are known, and names of
/// files and folders. It asks no program when it runs and needs nothing but bash 4.
[[nodiscard]] std::string bash_completion(const ProgramWords& program);

}  // namespace rigor
