// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/format.h"

#include <algorithm>
#include <array>

namespace rigor {

Format format_of(std::string_view path) {
  static constexpr auto endings = std::to_array<std::string_view>({".tex", ".ltx", ".latex", ".sty"});
  const bool latex = std::any_of(endings.begin(), endings.end(),
                                 [&](std::string_view ending) { return path.ends_with(ending); });
  return latex ? Format::latex : Format::markdown;
}

}  // namespace rigor
