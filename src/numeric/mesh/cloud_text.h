// SPDX-License-Identifier: GPL-3.0-or-later
// Points from text.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rigor {

/// x, y, z and m of all points of a `.txt` or `.csv` file, see cloud_file.h. Cost: that of `from_chars`; the
/// text is not copied. At most `most_particles`.
[[nodiscard]] Result<std::array<std::vector<double>, 4>> parse_cloud(std::string_view text);

}  // namespace rigor
