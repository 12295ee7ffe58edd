// SPDX-License-Identifier: GPL-3.0-or-later
// Directives about symbols, axes and frames.
#pragma once

#include "check/walk/state.h"

namespace rigor {

void take_declaration(Walk& walk, const Directive& directive);
/// A plain letter that would be the length of a vector is a number of its own where it is given a meaning.
void declare_for_now(Walk& walk, const Directive& directive, SyntaxId id);

}  // namespace rigor
