// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/small_proofs.h"

#include <numeric>

namespace rigor {
namespace {

constexpr Limits brief{.expanded_terms = 30'000,
                       .steps = 400'000,
                       .sample_attempts = 12,
                       .fewest_assumptions = false,
                       .simplest_sample = false};

std::vector<std::size_t> all_of(std::size_t count) {
  std::vector<std::size_t> positions(count);
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  return positions;
}

}  // namespace

Decision SmallProofs::decide_with(ExprId left, ExprId right, const std::vector<std::size_t>& definitions,
                                  const std::vector<std::size_t>& assumptions) {
  Question question{.tree = &tree_, .claim = question_.claim};
  question.claim.left = left;
  question.claim.right = right;
  question.claim.relation = Relation::equal;
  for (const std::size_t k : definitions) question.definitions.push_back(question_.definitions[k]);
  for (const std::size_t k : assumptions) question.assumptions.push_back(question_.assumptions[k]);
  question.zeroed = question_.zeroed;
  return decide(question, brief);
}

bool SmallProofs::equal(ExprId left, ExprId right) {
  const auto [entry, fresh] = known_.try_emplace({left, right}, false);
  if (!fresh) return entry->second;
  const auto proved = [&](const std::vector<std::size_t>& definitions,
                          const std::vector<std::size_t>& assumptions) {
    return decide_with(left, right, definitions, assumptions).outcome == Outcome::proved;
  };
  entry->second = proved({}, {}) || proved(all_of(question_.definitions.size()), {}) ||
                  proved(all_of(question_.definitions.size()), all_of(question_.assumptions.size()));
  return entry->second;
}

}  // namespace rigor
