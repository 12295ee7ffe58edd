// SPDX-License-Identifier: GPL-3.0-or-later
// What an author would add to notes whose vectors go undeclared: a directive that a statement is meant for
// all of them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "check/notes.h"
#include "check/report.h"

namespace rigor::twins {

/// `unit vector \hat{\mathbf{n}}` for each letter that is bold or has an arrow somewhere in the notes,
/// `scalar k` for the other letters that stand alone. Not for axes, and not for what the notes define, since
/// a declaration would forget the definition.
[[nodiscard]] std::set<std::string> declarations(const Notes& notes, const std::vector<Step>& steps);

}  // namespace rigor::twins
