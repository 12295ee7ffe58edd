// SPDX-License-Identifier: GPL-3.0-or-later
// The groups in which a place of LaTeX notes lies, so that what is defined in one ends with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latex/token/environments.h"

namespace rigor {

enum class GroupMark : std::uint8_t {
  brace,        // {
  argument,     // { of a control that carries its argument out where it stands: \AtBeginDocument{…}
  environment,  // \begin{…}
  begingroup,   // \begingroup, \bgroup
};

class MacroGroups {
 public:
  void open(GroupMark mark, std::string_view name = {}) { open_.push_back({mark, std::string(name)}); }
  /// Something is about to be defined. Returns how many groups it is the first definition in.
  std::size_t define(const EnvironmentAliases& aliases);
  /// Returns how many groups with definitions end here; `aliases` is then what it was before them. A mark
  /// that closes nothing ends none, one that closes an outer group ends those inside it.
  std::size_t close(GroupMark mark, std::string_view name, EnvironmentAliases& aliases);

 private:
  struct Group {
    GroupMark mark;
    std::string name;
    std::optional<EnvironmentAliases> before = {};  // where something is defined
  };
  [[nodiscard]] std::size_t opening_of(GroupMark mark, std::string_view name) const;

  std::vector<Group> open_;
};

/// Whether the braces after `control` are no group: `\AtBeginDocument`, `\IfFileExists`, `\@ifundefined`.
[[nodiscard]] bool carries_out_argument(std::string_view control);

}  // namespace rigor
