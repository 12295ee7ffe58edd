// SPDX-License-Identifier: GPL-3.0-or-later
// Conditions on index values in a definition by cases: "ijk = 123 or cyclic permutations", "(i,j,k) is an odd
// permutation of (1,2,3)", "i = j", "any two indices are equal", "otherwise".
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// For each of the 3^n tuples of the letters (first letter most significant, axes 1..3) whether the condition
/// holds; nothing if the words are not understood. Letters may be in any order in the condition.
[[nodiscard]] std::optional<std::vector<bool>> read_index_condition(const std::string& words,
                                                                    const std::vector<std::string>& letters);

}  // namespace rigor
