// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// Text as it may stand between tags and in quoted attributes of XML and HTML; what XML cannot hold becomes
/// `?`.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace rigor
