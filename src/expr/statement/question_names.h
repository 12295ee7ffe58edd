// SPDX-License-Identifier: GPL-3.0-or-later
// How notes call what a question rests on, for whoever explains a step.
#pragma once

#include <string>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// How the definitions and assumptions of a question are called: `Eq. (8)`, `the centre of mass`; one for
/// each.
struct QuestionNames {
  std::vector<std::string> definitions;
  std::vector<std::string> assumptions;
};

/// `≈` as it was written, with what holds exactly: the sides may differ by what is of second order in `small`
/// (symbols, or components of them) and in their derivatives.
struct NearlyQuestion {
  Question exact;  // its `tree` is not set
  QuestionNames names;
  std::vector<ExprId> small;
};

}  // namespace rigor
