// SPDX-License-Identifier: GPL-3.0-or-later
// An equation solved for a symbol in it.
#pragma once

#include <string>
#include <vector>

#include "app/hole/hole_answers.h"

namespace rigor {

struct SolvedStatement {
  SourceMap sources = {};
  std::vector<std::string> roots = {};  // LaTeX; each was put in for the symbol and proved
  std::string obstacle = {};            // why there are none, or not all
  Diagnostics diagnostics = {};         // of what cannot be read
  bool malformed = false;
};

/// The statement of `notes` is one equation without holes. Never throws for anything in it.
[[nodiscard]] SolvedStatement solve_statement(const HoleNotes& notes, const std::string& symbol);

}  // namespace rigor
