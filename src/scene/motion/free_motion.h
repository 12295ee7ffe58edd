// SPDX-License-Identifier: GPL-3.0-or-later
// The motion in closed form (torque_free.h) in place of the integrated one, where the notes' own law says
// that the body is free: its rates, as compiled from the notes, agree with those of a free body with these
// moments wherever the motion comes and elsewhere. Any other law is integrated as the notes say.
#pragma once

#include <optional>

#include "numeric/body/body.h"
#include "numeric/kernels/high_low.h"
#include "scene/motion/motion.h"

namespace rigor {

/// `moments` along the axes of the spin. Nothing where the rates differ by more than 16 u (Iⱼ + Iₖ)/Iᵢ |ω|²,
/// what rounding gives, or by more than takes the spin off by the request's tolerance in its duration, to
/// first order: at 32 fixed spins of the size of the first, at the spins of the motion in every row, and at
/// 1024 over a period or the duration, whichever is shorter. Nothing either for |ω| outside 1e-140 to 1e100
/// (so for a body at rest), where a row is not finite (beyond 2^47 turns), and for what `integrate` would
/// refuse, and for a spin along the middle axis alone at which the law's rates are not 0 exactly. It wrongly
/// accepts a law that differs only between these spins, and wrongly rejects one whose equations round worse
/// than that, which is then integrated.
[[nodiscard]] std::optional<Motion> free_motion(const SpinRates& rates, const Position& moments,
                                                const MotionRequest& request);

/// The low parts of the moments, which the closed form leaves out, change no gap Iⱼ − Iₖ by more than 1e-12
/// of it, or else, to first order, the spin by less than the tolerance in the duration.
[[nodiscard]] bool high_parts_suffice(const SharpPosition& moments, const MotionRequest& request);

}  // namespace rigor
