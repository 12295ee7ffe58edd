// SPDX-License-Identifier: GPL-3.0-or-later
// Which files below a folder are notes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace rigor {

struct FolderNotes {
  std::vector<std::string> files = {};
  // what is not checked by itself
  std::uint32_t without_displays = 0;  // files that are no notes
  std::uint32_t read_by_others = 0;    // files that another one reads with \input
  std::uint32_t folders = 0;           // hidden ones, those of builds
  std::uint32_t links = 0;             // symbolic ones are not followed
};

/// LaTeX and Markdown files with displayed equations or directives, in the order of their paths: the same on
/// every machine. Of files that read each other in a circle the first is checked. An error: the folder, or
/// one below it, cannot be read. Cost: each file is read once more, without deciding anything.
[[nodiscard]] Result<FolderNotes> notes_in_folder(const std::string& folder);

/// `2 files without displayed equations, 1 hidden or build folder`; empty if all was taken.
[[nodiscard]] std::string print_passed_over(const FolderNotes& found);

}  // namespace rigor
