// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace rigor {

/// Writes a file, or to a device. An error is the reason why not all was written.
[[nodiscard]] Result<void> write_file(const std::string& path, std::string_view text);

/// The same through a new file next to it that takes its place: whoever reads sees all of the old text or all
/// of the new, also if several processes write.
[[nodiscard]] Result<void> replace_file(const std::string& path, std::string_view text);

}  // namespace rigor
