// SPDX-License-Identifier: GPL-3.0-or-later
// What a command line and a settings file ask to be checked, as a list of notes.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "app/grammar/command_line.h"
#include "app/host/settings.h"
#include "base/result.h"

namespace rigor {

struct NotesToCheck {
  struct Item {
    std::string path;
    std::optional<std::string> text = {};     // of the standard input
    std::optional<std::string> sidecar = {};  // that is named; else the one beside the notes
  };
  std::vector<Item> items = {};
  std::vector<std::string> remarks = {};  // what was passed over in folders
};

/// Folders become the notes below them, `-` what `in` has; each file comes once. An error: there are no notes
/// below a folder, or it cannot be read, or there is too much on the standard input.
[[nodiscard]] Result<NotesToCheck> notes_to_check(const CheckCommand& command, const Settings& settings,
                                                  std::istream& in);

}  // namespace rigor
