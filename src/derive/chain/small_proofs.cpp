// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/small_proofs.h"

namespace rigor {
namespace {

constexpr Limits limits_of_small_proofs{.expanded_terms = 30'000,
                                        .steps = 400'000,
                                        .sample_attempts = 12,
                                        .fewest_assumptions = false,
                                        .simplest_sample = false};

}  // namespace

Decision SmallProofs::decide_from(ExprId left, ExprId right, std::vector<Definition> definitions,
                                  std::vector<Equation> assumptions) {
  Question question{.tree = &tree_,
                    .claim = question_.claim,
                    .definitions = std::move(definitions),
                    .assumptions = std::move(assumptions),
                    .zeroed = question_.zeroed};
  question.claim.left = left;
  question.claim.right = right;
  return decide(question, limits_of_small_proofs);
}

bool SmallProofs::equal(ExprId left, ExprId right, const std::vector<IndexId>& free) {
  const auto [entry, fresh] = known_.try_emplace({left, right}, false);
  if (!fresh) return entry->second;
  const auto proved = [&](bool definitions, bool assumptions) {
    Question question{.tree = &tree_, .claim = question_.claim};
    question.claim.left = left;
    question.claim.right = right;
    question.claim.indices = free;
    if (definitions) question.definitions = question_.definitions;
    if (assumptions) question.assumptions = question_.assumptions;
    if (definitions) question.zeroed = question_.zeroed;
    return decide(question, limits_of_small_proofs).outcome == Outcome::proved;
  };
  entry->second = proved(false, false) || (!question_.definitions.empty() && proved(true, false)) ||
                  (!question_.assumptions.empty() && proved(true, true));
  return entry->second;
}

}  // namespace rigor
