// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/format.h"

#include <algorithm>
#include <array>

namespace rigor {

Format format_of(std::string_view path) {
  static constexpr auto endings = std::to_array<std::string_view>({".tex", ".ltx", ".latex", ".sty"});
  const bool latex =
      std::ranges::any_of(endings, [&](std::string_view ending) { return path.ends_with(ending); });
  return latex ? Format::latex : Format::markdown;
}

}  // namespace rigor
