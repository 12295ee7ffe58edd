// SPDX-License-Identifier: GPL-3.0-or-later
// The motion in closed form (torque_free.h) in place of the integrated one, where the notes' own law says
// that the body is free: its rates, as compiled from the notes, agree with those of a free body with these
// moments at many spins. Any other law is integrated as the notes say.
#pragma once

#include <optional>

#include "numeric/body.h"
#include "scene/motion.h"

namespace rigor {

/// `moments` along the axes of the spin. Nothing where the rates differ, at any of 32 fixed spins of the size
/// of the first, by more than 512 u (Iⱼ + Iₖ)/Iᵢ |ω|²; also for a body at rest and for what `integrate` would
/// refuse. The tolerance wrongly accepts a torque that turns the spin by less than 1e-13 rad a turn; it
/// wrongly rejects a law whose equations round worse than that, which is then integrated.
[[nodiscard]] std::optional<Motion> free_motion(const SpinRates& rates, const Position& moments,
                                                const MotionRequest& request);

}  // namespace rigor
