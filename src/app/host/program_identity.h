// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace rigor {

/// What tells this build of the program, and the libraries that it is linked to, from any other: the version
/// and the build identifiers (`NT_GNU_BUILD_ID`) of all that is loaded. What has no such identifier counts
/// with its path, its size and the time of its last change.
[[nodiscard]] std::string program_identity();

}  // namespace rigor
