// SPDX-License-Identifier: GPL-3.0-or-later
// A counterexample as a lecturer checks it by hand:
//
//   sample: \mathbf{A} = (1, 0, 0), \mathbf{B} = (0, 1, 0); component i = 3: left 1, right -1
//
// and with particles, each on a line of its own:
//
//   sample: 2 particles, \mathbf{R} = (0, 0, 1)
//     particle 1: m_{\alpha} = 1, \mathbf{r}_{\alpha} = (1, 0, 0)
//     particle 2: m_{\alpha} = 2, \mathbf{r}_{\alpha} = (0, 0, 0)
//     component i = 1, j = 2: left 1, right -1
//
// What the values make of defined symbols in the step is after them: `m = 1; hence M = 1`. Derivatives
// that only derivatives of assumptions speak of are left out; the JSON has them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/step/report.h"

namespace rigor {

/// Ends with a line break. A tensor is printed row by row: `((1, 0, 0), (0, 1, 0), (0, 0, 1))`.
[[nodiscard]] std::string print_sample(const Counterexample& sample, bool color = false);

/// The values of one particle (0: of no particle) as equations in LaTeX: `\mathbf{A} = (1, 0, 0)`; first
/// those of the sample, then what follows from them.
[[nodiscard]] std::vector<std::string> sample_equations(const Counterexample& sample, std::uint32_t particle);

/// `component i = 3`; empty where the sides are scalars.
[[nodiscard]] std::string sample_component(const Counterexample& sample);

}  // namespace rigor
