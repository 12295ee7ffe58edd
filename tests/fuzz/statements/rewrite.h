// SPDX-License-Identifier: GPL-3.0-or-later
// Rewritings that leave a term's value as it is, and slips that mostly do not. Whether a statement made with
// them is true is for `evaluate.h` to say.
#pragma once

#include "random.h"
#include "statement.h"

namespace fuzz {

/// The term with up to `count` rewritings carried out in it, at places taken at random.
[[nodiscard]] Term rewritten(Term term, const std::vector<Letter>& letters, int count, Random& random);

/// The term with one slip in it: a sign, a factor, an exchanged letter or index, a term too few.
[[nodiscard]] Term mistaken(const Term& term, const std::vector<Letter>& letters, Random& random);

/// Indices that do not occur in `term`.
[[nodiscard]] std::string unused_indices(const Term& term);

using Rule = Term (*)(const Term&, struct Scene&);

/// What a rule may look at besides its term.
struct Scene {
  const std::vector<Letter>& letters;
  Random& random;
  std::string fresh;  // indices that the whole side does not use
};

[[nodiscard]] const std::vector<Rule>& scalar_rules();
[[nodiscard]] const std::vector<Rule>& vector_rules();
[[nodiscard]] const std::vector<Rule>& index_rules();
[[nodiscard]] const std::vector<Rule>& derivative_rules();

}  // namespace fuzz
