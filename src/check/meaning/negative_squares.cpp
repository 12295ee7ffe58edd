// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/negative_squares.h"

#include "algebra/decide/decide.h"

namespace rigor {
namespace {

/// Does the sample give the claim's sides values that are not related as it says?
[[nodiscard]] bool fails_on(Question question, const Equation& claim, Sample sample) {
  question.claim = claim;
  sample.axes.clear();
  sample.free_particles.clear();
  const Replay replay = replay_closely(question, sample);
  return replay.fault == Replay::Fault::none && replay.differ;
}

}  // namespace

std::vector<NegativeSquare> negative_squares_of_sample(ExprTree& tree, const Names& names,
                                                       const Question& question, const Sample& sample) {
  std::vector<NegativeSquare> found;
  for (const NamedDefinition& named : names.scope.definitions) {
    const Definition& definition = named.definition;
    if (!definition.by_square || tree[definition.body].op != Op::root) continue;
    const ExprId square = tree.children(definition.body)[0];
    NegativeSquare each{.name = definition.symbol, .not_negative = {}, .negative = {}};
    const ExprId zero = tree.add_number(tree[square].span, "0");
    each.not_negative = {.left = zero, .right = square, .relation = Relation::less_or_equal};
    each.negative = {.left = square, .right = zero, .relation = Relation::less};
    Question asked = question;
    asked.tree = &tree;
    if (fails_on(std::move(asked), each.not_negative, sample)) found.push_back(each);
  }
  return found;
}

}  // namespace rigor
