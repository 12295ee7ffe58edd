// SPDX-License-Identifier: GPL-3.0-or-later
// `x = a\cos\omega t + b\sin\omega t` follows from no equation of motion, since other motions obey it, too.
// It solves it.
#pragma once

#include <optional>

#include "check/law/from_set.h"

namespace rigor {

/// Does the row, `x = …` without x on the right, solve the nearest law with a derivative of x? Put in, the
/// law holds, and the row has as many independent free constants as the order of the law says, two at most:
/// then it is what the law leaves open. `uses` names the law and what else is needed for that.
[[nodiscard]] std::optional<Judgement> solves(const RowUnderLaws& row, const Laws& bearing);

}  // namespace rigor
