// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that are said to be a mass, a radius, a frequency: "a particle of mass $m$", "where $R$ is the
// radius". Such a quantity is not negative, and as long as there is something that has it, not 0. The lists
// are closed, and are in docs/notation.md.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rigor {

struct SaidSize {
  std::size_t maths = 0;  // of the sentence, counted from 0
  std::string_view noun;  // "mass", also of "masses"
};

/// `sentence` as in `ProseBeside`. Only a noun right before the letter, or one that a verb or an article
/// joins to it, says what it is.
[[nodiscard]] std::vector<SaidSize> said_sizes(std::string_view sentence);

/// `\hbar`, `\varepsilon_0`: the constants of nature that have one letter everywhere.
[[nodiscard]] bool is_positive_constant(std::string_view name);

}  // namespace rigor
