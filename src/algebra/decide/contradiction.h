// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions that have no solution: nothing is proved from them.
#pragma once

#include "algebra/decide/decide.h"

namespace rigor {

/// Do the assumptions of a question, its definitions unfolded, have no solution at the generic point? That is
/// a proof; false where none was found. The claim says nothing that holds, and is about the same symbols.
[[nodiscard]] bool assumptions_contradict(const Question& question, const Limits& limits);

}  // namespace rigor
