// SPDX-License-Identifier: GPL-3.0-or-later
// Rigor as a user runs it, and as a function in this process; both work in `tests/notes`.
#pragma once

#include <string>
#include <vector>

#include "check/step/report.h"

namespace rigor {

/// How a run ended, and what was printed on either stream.
struct Outcome {
  int code = 0;  // minus the signal's number if one ended the program
  std::string text;
};

/// `rigor ARGUMENTS…` in a process of its own, with the program that this build made.
[[nodiscard]] Outcome run_program(const std::vector<std::string>& arguments);

/// The same through `run`.
[[nodiscard]] Outcome run_inside(const std::vector<std::string>& arguments);

/// What the program would end with after this file alone, not `--strict`.
[[nodiscard]] int exit_code_of(const FileReport& file);

/// Every note of a folder (not of those inside it) as a path, sorted.
[[nodiscard]] std::vector<std::string> notes_in(const std::string& folder);

/// The bytes of a file that must be there.
[[nodiscard]] std::string text_of(const std::string& path);

}  // namespace rigor
