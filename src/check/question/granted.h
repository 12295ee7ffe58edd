// SPDX-License-Identifier: GPL-3.0-or-later
// A relation of the page that is taken for granted.
#pragma once

#include "elaborate/name/names.h"

namespace rigor {

/// As a definition where the left side is a letter alone that nothing defines and that the right side does
/// not lead to: then it is put in, wherever the letter stands. Else as an assumption; so is what it says of
/// the value of a function.
void take_for_granted(const ExprTree& tree, Names& names, const Equation& equation, Origin origin,
                      bool at_instant);

}  // namespace rigor
