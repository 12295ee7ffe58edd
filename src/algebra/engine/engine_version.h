// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace rigor {

/// The libraries that decide, as linked: `GiNaC 1.8.6, CLN 1.3.6`.
[[nodiscard]] std::string engine_version();

}  // namespace rigor
