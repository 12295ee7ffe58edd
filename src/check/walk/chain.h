// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sides of a chain, then takes its steps one after the other. Sides are read together because they
// share their index letters.
#pragma once

#include "check/walk/state.h"

namespace rigor {

void follow_chain(Walk& walk, const ParsedChain& parsed, const Context& context);
void report_unmet(Walk& walk, const Directive& expectation, Span statement);

}  // namespace rigor
