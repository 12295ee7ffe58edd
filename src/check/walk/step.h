// SPDX-License-Identifier: GPL-3.0-or-later
// One relation of a chain, from what is written to its step in the report. It is read first: it brings
// something into scope, claims something, or cannot be decided. What it claims is asked, and the answer may
// give a name another meaning; only then do the words around it bear on its verdict.
#pragma once

#include "check/walk/state.h"

namespace rigor {

[[nodiscard]] Step new_step(const Walk& walk, const ParsedChain& parsed, std::size_t which,
                            const Context& context);
void add_step(Walk& walk, Step step);
void take_step(Walk& walk, const ParsedChain& parsed, std::size_t which, ChainReading& reading,
               const Context& context);

}  // namespace rigor
