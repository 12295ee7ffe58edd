// SPDX-License-Identifier: GPL-3.0-or-later
// The MD5 digest of bytes (RFC 1321): a name for a content, as TeX computes it of a file, too. No protection
// against anybody who wants two contents with one digest.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// 32 hexadecimal digits, lower case. Cost: linear, about 2 ns a byte.
[[nodiscard]] std::string md5(std::string_view bytes);

}  // namespace rigor
