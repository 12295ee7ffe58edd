// SPDX-License-Identifier: GPL-3.0-or-later
// What an explanation asks the exact side: other claims under the definitions and assumptions of a question.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "algebra/decide/decide.h"
#include "expr/statement/statement.h"

namespace rigor {

class SmallProofs {
 public:
  /// `question` is kept by reference; its `tree` is not read.
  SmallProofs(const ExprTree& tree, const Question& question) : tree_(tree), question_(question) {}

  /// The question's claim, or another one with its free letters, from these definitions and assumptions.
  [[nodiscard]] Decision decide_from(ExprId left, ExprId right, std::vector<Definition> definitions,
                                     std::vector<Equation> assumptions);
  /// From nothing, or from the question's definitions and assumptions. Known pairs are not asked again.
  [[nodiscard]] bool equal(ExprId left, ExprId right, const std::vector<IndexId>& free);

 private:
  const ExprTree& tree_;
  const Question& question_;
  std::map<std::pair<ExprId, ExprId>, bool> known_;
};

}  // namespace rigor
