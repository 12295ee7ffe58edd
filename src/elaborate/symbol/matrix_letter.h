// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that the section sets equal to a written matrix or column, their entries, and unit matrices.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Nothing where the letter is none. Where the section leaves open what it is, or the matrix has not been
/// read, there is a diagnostic: a matrix of which nothing is known would refute what holds for this one.
[[nodiscard]] std::optional<MaybeTyped> matrix_letter(Reading& reading, const WrittenSymbol& written,
                                                      Span span);

/// I that nothing defines, and what the words call the unit matrix: beside a matrix in a sum it is one.
[[nodiscard]] bool may_be_unit_matrix(const Reading& reading, const WrittenSymbol& written);

}  // namespace rigor
