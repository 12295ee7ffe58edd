// SPDX-License-Identifier: GPL-3.0-or-later
// One relation of a chain, from what is written to its step in the report. First it is read: it brings
// something into scope, claims something, or cannot be decided. A claim is put to the exact side, whose
// answer may show that a name has another meaning here. Only then do the words around it bear on the verdict.
#pragma once

#include "check/walk/state.h"

namespace rigor {

[[nodiscard]] Step new_step(const Walk& walk, const ParsedChain& parsed, std::size_t which,
                            const Context& context);
void add_step(Walk& walk, Step step);
void take_step(Walk& walk, const ParsedChain& parsed, std::size_t which, ChainReading& reading,
               const Context& context);

}  // namespace rigor
