// SPDX-License-Identifier: GPL-3.0-or-later
// What an explanation may start from: definitions, assumptions, and equations that were proved before.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "derive/chain/descent.h"
#include "derive/chain/small_proofs.h"
#include "expr/statement/question_names.h"

namespace rigor {

/// An equation, as it is called, with the definitions that it rests on.
struct KnownEquation {
  Equation equation;
  std::string name;
  std::vector<Definition> definitions = {};
};

struct Basis {
  std::vector<NamedRule> definitions;
  std::vector<KnownEquation> assumptions;
};

/// All that a question names.
[[nodiscard]] Basis whole_basis(const Question& question, const QuestionNames& names);

/// What of a basis cannot be left out if the claim is to be proved; nothing where it is not proved at all.
[[nodiscard]] std::optional<Basis> needed_of(SmallProofs& proofs, const Question& question, Basis basis);

/// With known equations instead of definitions where they say what a symbol is, and before assumptions.
/// `latest`: of several, the last one. Nothing where no known equation speaks of the claim.
[[nodiscard]] std::optional<Basis> with_known(const ExprTree& tree, const Question& question, Basis basis,
                                              std::span<const KnownEquation> known, bool latest);

/// The question with the definitions behind known equations, of symbols that it does not speak of. The latest
/// one counts.
[[nodiscard]] Question widened(const ExprTree& tree, Question question, std::span<const KnownEquation> known);

/// The rules of a descent.
[[nodiscard]] DescentRules rules_of(ExprTree& tree, const Question& question, const Basis& basis,
                                    Orientation orientation);

}  // namespace rigor
