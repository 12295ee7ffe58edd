// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/grammar/command_line.h"

namespace rigor {

/// An expression that was written as LaTeX, in the format that is asked for.
[[nodiscard]] std::string in_format(const std::string& latex, MathFormat format);

}  // namespace rigor
