// SPDX-License-Identifier: GPL-3.0-or-later
// How notes write what the tree only means: the faces of their vectors and tensors, their ε, their basis.
#pragma once

#include "check/event/notes.h"
#include "elaborate/name/names.h"
#include "expr/print/notation.h"
#include "expr/tree/tree.h"

namespace rigor {

/// Where the notes write a thing in several ways, the most frequent one. Of the faces, those that amsmath
/// knows. `names` has all of the file's symbols. Cost: linear in the notes.
[[nodiscard]] Notation notation_of_notes(const Notes& notes, const Names& names, const ExprTree& tree);

}  // namespace rigor
