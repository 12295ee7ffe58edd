// SPDX-License-Identifier: GPL-3.0-or-later
// Letters whose value the page gives in a roundabout way: `E_1` by `E_n = -\kappa/2an^2`, `\omega_p` by its
// square, κ by "with $\kappa = e^2/4\pi\varepsilon_0$".
#pragma once

#include "check/row/given_values.h"

namespace rigor {

/// The names with definitions of those letters that the value leads to and nothing defines; `lines` say what
/// some of them are.
[[nodiscard]] Names with_members(RowPlace& place, Names names, ExprId value,
                                 const std::vector<GivenValue>& lines);

}  // namespace rigor
