// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <system_error>

#include "base/result.h"

namespace rigor {

/// What the operating system says, as a reason: `no such file or directory`.
[[nodiscard]] Error error_of(std::error_code code);

}  // namespace rigor
