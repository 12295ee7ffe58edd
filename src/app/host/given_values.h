// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for letters, as they are typed: `x = 1e-9, \mathbf{A} = (1, 0, 2)`.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rigor {

/// By the letter's name. Refused with the part that is not understood.
[[nodiscard]] Result<std::map<std::string, std::vector<double>>> read_given_values(std::string_view text);

}  // namespace rigor
