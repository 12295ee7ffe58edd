// SPDX-License-Identifier: GPL-3.0-or-later
// The motion by equal steps that are split: half a kick by what the law has beyond that of a free rigid body,
// a free turn in closed form (torque_free_step.h), half a kick. The free turn is exact, so steps need to
// resolve the kicks alone. The method is of order 2 and goes backwards as it came; it is symplectic where
// both parts are Hamiltonian, and then constants of the motion swing about their values and do not run away.
// Sources: G. Strang, SIAM J. Numer. Anal. 5 (1968) 506; J. Touma, J. Wisdom, Astron. J. 107 (1994) 1189.
#pragma once

#include <cstddef>

#include "numeric/kernels/position.h"
#include "scene/motion/motion.h"

namespace rigor {

/// `moments` along the axes of the spin; `split` steps from row to row, at least 1. The kicks' own motion is
/// integrated to 1e-13; of the request's tolerance nothing is used. With the order that was measured: log₂ of
/// the greatest change of the spin in any row by twice as many steps, over that by twice as many again; none
/// where the latter is below 1e-10 of the greatest spin and what rounding makes of its phase, as for a body
/// without a torque.
[[nodiscard]] Motion split_motion(const SpinRates& rates, const Position& moments,
                                  const MotionRequest& request, std::size_t split);

}  // namespace rigor
