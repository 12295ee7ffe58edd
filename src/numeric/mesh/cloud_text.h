// SPDX-License-Identifier: GPL-3.0-or-later
// Points from text.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rigor {

/// x, y, z and m of all points of a `.txt` or `.csv` file, see cloud_file.h. Cost: that of `from_chars`; the
/// text is not copied. At most `most_particles`. `parsed(begin, count)` is called now and then with the bytes
/// that are not looked at any more.
[[nodiscard]] Result<std::array<std::vector<double>, 4>> parse_cloud(
    std::string_view text, const std::function<void(std::size_t, std::size_t)>& parsed = {});

}  // namespace rigor
