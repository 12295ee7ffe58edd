// SPDX-License-Identifier: GPL-3.0-or-later
#include "statement.h"

namespace fuzz {

bool well_formed(const Claim& claim, const std::vector<Letter>& letters) {
  std::string left;
  std::string right;
  if (!well_formed(claim.left, letters, left) || !well_formed(claim.right, letters, right)) return false;
  const bool order = claim.relation != Relation::equal && claim.relation != Relation::nearly;
  if (order && !(left.empty() && right.empty())) return false;
  return left == right && claim.left->rank == claim.right->rank;
}

bool well_formed(const Statement& statement) {
  for (std::size_t k = 0; k < statement.steps(); ++k)
    if (!well_formed(statement.step(k), statement.letters)) return false;
  return true;
}

}  // namespace fuzz
