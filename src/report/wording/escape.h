// SPDX-License-Identifier: GPL-3.0-or-later
// Text from notes, and paths, as parts of formats that programs read. Nothing in them can end a string, an
// element or a line before its time; bytes that are not UTF-8 become U+FFFD.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// A path as a relative reference (RFC 3986), byte by byte; an absolute path as a `file:` URI.
[[nodiscard]] std::string uri_of_path(std::string_view path);

/// The message of a GitHub workflow command, and the value of one of its properties.
[[nodiscard]] std::string workflow_message(std::string_view text);
[[nodiscard]] std::string workflow_property(std::string_view text);

}  // namespace rigor
