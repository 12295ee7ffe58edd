// SPDX-License-Identifier: GPL-3.0-or-later
// Words of sentences that pose a problem in a line: "We solve $y'' = -y$", "the ansatz $y = e^{rx}$ gives".
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// "The ansatz $x = Ae^{\lambda t}$ leads to", "inserting $x = …$", "solutions of the form".
[[nodiscard]] bool speaks_of_a_trial(const std::string& sentence);

/// "It is wrong that", "compared with", "instead of": no problem is posed. `tries`: a trial solution is one,
/// also where it "works if".
[[nodiscard]] bool turns_a_problem_down(const std::string& sentence, bool tries = false);

/// "We insert this and find": what the display above says is meant here.
[[nodiscard]] bool points_at_the_row_above(std::string_view lead);

}  // namespace rigor
