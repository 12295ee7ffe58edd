// SPDX-License-Identifier: GPL-3.0-or-later
// What a letter is, it is in its whole section, also above the line that says so: declarations are put in
// front of all else that is in their section, after a frame that is above them.
#pragma once

#include <vector>

#include "check/event/notes.h"

namespace rigor {

/// First what letters are, then how they change and whether all their values are meant; else in the order of
/// the notes. A second declaration of the same letter stays where it is: from there on the letter is
/// something else.
[[nodiscard]] std::vector<Event> with_declarations_first(std::vector<Event> events, const SyntaxTree& syntax);

}  // namespace rigor
