// SPDX-License-Identifier: GPL-3.0-or-later
// Claims with a root that fail by a sign of something that is not meant for all values: whether its author
// means such values, nothing says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/question/decision_cache.h"
#include "elaborate/name/scope.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Does the claim have a root, a length or an absolute value, itself or by a definition?
[[nodiscard]] bool asks_for_real_numbers(const ExprTree& tree, const Question& question);

struct SignDoubt {
  std::string name;    // of what is not meant for all values
  std::string reason;  // why its values do not refute
  std::vector<std::string> help;
};

/// `|m\mathbf v| = mv` fails for negative m, but a mass is not negative; `\cos\varphi = \sqrt{1 -
/// \sin^2\varphi}` fails by a sign alone (the squares are proved to be equal), where the cosine is negative.
/// `sample`: on which the question's claim fails. Its tree grows.
[[nodiscard]] std::optional<SignDoubt> doubt_of_signs(ExprTree& tree, const Question& question,
                                                      const NameScope& scope, const Sample& sample,
                                                      DecisionCache* cache);

}  // namespace rigor
