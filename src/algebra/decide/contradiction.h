// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions that contradict each other. They would prove anything, so nothing is proved from them.
#pragma once

#include "algebra/decide/decide.h"

namespace rigor {

/// Is it proved that the assumptions of a question, its definitions unfolded, have no solution at the generic
/// point? `false` only says that no proof was found. The claim must be a false one about the same symbols:
/// assumptions that prove it contradict each other.
[[nodiscard]] bool assumptions_contradict(const Question& question, const Limits& limits);

}  // namespace rigor
