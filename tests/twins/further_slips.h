// SPDX-License-Identifier: GPL-3.0-or-later
// More slips of the pen, for the search of what was meant: two things exchanged, a face, a function, a factor
// at the wrong place. The twins of derivations/ are not made with them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "latex/token/tokens.h"
#include "mutate.h"

namespace rigor::twins {

/// All such edits of one side, given the statement's sides (for the letters that occur in it). No two are
/// alike, none changes nothing.
[[nodiscard]] std::vector<Edit> further_slips_of(const SourceMap& sources, TokenView side,
                                                 const std::vector<TokenView>& statement);

}  // namespace rigor::twins
