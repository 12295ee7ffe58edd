// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macro_groups.h"

#include <algorithm>
#include <array>

namespace rigor {

std::size_t MacroGroups::define(const EnvironmentAliases& aliases) {
  std::size_t first = 0;
  for (Group& group : open_) {
    if (group.before || group.mark == GroupMark::argument) continue;
    group.before = aliases;
    ++first;
  }
  return first;
}

std::size_t MacroGroups::close(GroupMark mark, std::string_view name, EnvironmentAliases& aliases) {
  std::size_t ended = 0;
  for (const std::size_t left = opening_of(mark, name); open_.size() > left; open_.pop_back()) {
    if (!open_.back().before) continue;
    aliases = *open_.back().before;
    ++ended;
  }
  return ended;
}

/// The size where nothing is closed. A brace closes only what was opened last: those in the text of notes
/// need not be balanced.
std::size_t MacroGroups::opening_of(GroupMark mark, std::string_view name) const {
  if (mark == GroupMark::brace) {
    const bool brace =
        !open_.empty() && (open_.back().mark == GroupMark::brace || open_.back().mark == GroupMark::argument);
    return open_.size() - (brace ? 1 : 0);
  }
  for (std::size_t k = open_.size(); k > 0; --k) {
    if (open_[k - 1].mark == mark && open_[k - 1].name == name) return k - 1;
  }
  return open_.size();
}

bool carries_out_argument(std::string_view control) {
  static constexpr auto beginnings =
      std::to_array<std::string_view>({"@", "AddTo", "AfterE", "At", "If", "if"});
  return std::ranges::any_of(beginnings,
                             [&](std::string_view beginning) { return control.starts_with(beginning); });
}

}  // namespace rigor
