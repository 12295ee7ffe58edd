// SPDX-License-Identifier: GPL-3.0-or-later
// What an explanation asks the exact side: other claims under the definitions and assumptions of a question.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "algebra/decide.h"
#include "expr/statement.h"

namespace rigor {

class SmallProofs {
 public:
  /// `question` is kept by reference; its `tree` is not read.
  SmallProofs(const ExprTree& tree, const Question& question) : tree_(tree), question_(question) {}

  /// Is it proved, with no more definitions and assumptions than these positions?
  [[nodiscard]] Decision decide_with(ExprId left, ExprId right, const std::vector<std::size_t>& definitions,
                                     const std::vector<std::size_t>& assumptions);
  /// Without definitions and assumptions, or with all of them. Known pairs are not asked again.
  [[nodiscard]] bool equal(ExprId left, ExprId right);

 private:
  const ExprTree& tree_;
  const Question& question_;
  std::map<std::pair<ExprId, ExprId>, bool> known_;
};

}  // namespace rigor
