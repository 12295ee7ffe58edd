// SPDX-License-Identifier: GPL-3.0-or-later
// Chains that begin with the same name say how one quantity can be computed: T = a = b here, T = c there.
#pragma once

#include <vector>

#include "expr/statement/written_forms.h"

namespace rigor {

/// For each name that begins several chains, one chain of all their forms, at the place of the first: without
/// free letters, all steps proved or definitions, the same letters defined alike. Forms that read the same
/// stand once. The chains themselves are not among the result.
[[nodiscard]] std::vector<WrittenFormChain> forms_of_one_name(const WrittenForms& forms);

}  // namespace rigor
