// SPDX-License-Identifier: GPL-3.0-or-later
// What may be in a hole: expressions that are likely answers, the best first. They are proposals: whoever
// prints one puts it in and proves it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

enum class AnswerForm : std::uint8_t {
  contracted,  // index sums folded to direct notation
  expanded,    // multiplied out
  components,  // written out along 1, 2, 3
  factored,
  collected,    // as a polynomial in given expressions
  first_order,  // without what is of second order in given expressions
};

struct WantedForm {
  AnswerForm form = AnswerForm::contracted;
  std::vector<ExprId> by = {};  // collected and first_order
};

/// A hole in an equation: left is what its side is equal to, right its side.
struct HoleProblem {
  Question question;  // its `tree` is not read; its claim is not, either
  Equation claim;
  SymbolId hole{};
  ExprId node{};                   // the hole in the claim
  std::vector<ExprId> names;       // that fit, proved elsewhere
  bool nearly = false;             // equal to first order: the question is only of the order 0
  std::vector<ExprId> small = {};  // what is of first order there
};

struct Proposals {
  std::vector<ExprId> values = {};
  std::optional<ExprId> necessary = {};     // if anything fits, it equals this
  bool refuted_necessary = false;           // with it the claim is refuted, so that nothing fits
  std::string obstacle = {};                // why there are none
  std::optional<ExprId> may_be_added = {};  // any multiple of it can be added to an answer: there are many
  bool any_vector = false;                  // in `may_be_added` stands a symbol for any vector
  bool impossible = false;                  // the claim is refuted, whatever is in the hole
};

/// To first order, freedom and impossibility are not reported, since the order 0 alone does not show them.
/// Deterministic. Cost: a few decisions of the exact side.
[[nodiscard]] Proposals propose(ExprTree& tree, const HoleProblem& problem, const WantedForm& wanted);

/// The expression in a form: the likeliest first, which may be the expression as it is.
[[nodiscard]] std::vector<ExprId> in_form(ExprTree& tree, ExprId id, const WantedForm& wanted);

}  // namespace rigor
