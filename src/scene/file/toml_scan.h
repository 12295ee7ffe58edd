// SPDX-License-Identifier: GPL-3.0-or-later
// What a text is searched for before it is parsed as TOML: toml++ is undefined for characters beyond ASCII
// outside of strings and comments, where TOML allows none, and frees tables by recursion.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rigor {

struct TomlFlaw {
  std::size_t begin = 0;  // in bytes
  std::size_t end = 0;
  std::string message;
};

/// The first character beyond ASCII outside of strings and comments, or the first key of more than 64 parts.
[[nodiscard]] std::optional<TomlFlaw> find_toml_flaw(std::string_view text);

}  // namespace rigor
