// SPDX-License-Identifier: GPL-3.0-or-later
// A diagnostic about a statement that a sidecar makes is in the sidecar; a label shows which place in the
// notes it is about.
#pragma once

#include "check/event/notes.h"
#include "check/step/report.h"

namespace rigor {

/// What is said from the start of the notes is about no place.
void label_places(const Notes& notes, FileReport& report);

}  // namespace rigor
