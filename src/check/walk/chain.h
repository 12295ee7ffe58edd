// SPDX-License-Identifier: GPL-3.0-or-later
// A chain: how its sides are read, and its steps one after the other.
#pragma once

#include "check/walk/state.h"

namespace rigor {

void follow_chain(Walk& walk, const ParsedChain& parsed, const Context& context);
void report_unmet(Walk& walk, const Directive& expectation, Span statement);

}  // namespace rigor
