// SPDX-License-Identifier: GPL-3.0-or-later
// What an author would add to notes whose letters go undeclared: what they are, and that a statement is meant
// for all their values.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "check/event/notes.h"
#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor::twins {

/// `unit vector \hat{\mathbf{n}}` for each letter that is bold or has an arrow somewhere in the notes,
/// `scalar k` for the other letters that stand alone. Not for axes, and not for what the notes define, since
/// a declaration would forget the definition.
[[nodiscard]] std::set<std::string> declarations(const Notes& notes, const std::vector<Step>& steps);

/// `for all k` for each letter that these declare, or that the notes do.
[[nodiscard]] std::set<std::string> meant_for_all(const SourceMap& sources, const Notes& notes,
                                                  const std::set<std::string>& declarations);

}  // namespace rigor::twins
