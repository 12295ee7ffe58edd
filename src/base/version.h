// SPDX-License-Identifier: GPL-3.0-or-later
// The one place of the version number: `rigor --version`, the JSON and the build read it here.
#pragma once

#include <string_view>

namespace rigor {

inline constexpr std::string_view version = "0.2.0";

}  // namespace rigor
