// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// Text as it may be between tags and in quoted attributes of XML 1.0 and HTML. A character that XML
/// cannot have, and a byte that is not UTF-8, becomes U+FFFD; line breaks and tabs survive in attributes,
/// too.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace rigor
