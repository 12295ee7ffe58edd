// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/contracted.h"

#include <set>
#include <vector>

#include "derive/notation/letter_choice.h"
#include "derive/polynomial/collected.h"
#include "derive/polynomial/contraction.h"
#include "derive/polynomial/fold.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

constexpr int most_contractions = 60;

/// Letters that are in an expression and that no sum in it binds.
void note_free(const ExprTree& tree, ExprId root, LetterChoice& choice) {
  std::set<IndexId> bound;
  std::set<IndexId> present;
  for (const ExprId id : nodes_below(tree, {root})) {
    if (tree[id].op == Op::index_sum) bound.insert(tree[id].index);
    for (const Slot& slot : tree.slots(id)) {
      if (slot.axis == 0) present.insert(slot.variable);
    }
  }
  for (const IndexId letter : present) {
    if (!bound.contains(letter)) choice.taken.insert(tree.name(letter));
  }
}

ExprId with_good_letters(ExprTree& tree, ExprId id) {
  LetterChoice choice;
  note_free(tree, id, choice);
  return with_letters(tree, id, choice);
}

}  // namespace

void contract(ExprTree& tree, IndexPolynomial& polynomial) {
  for (int times = 0; times < most_contractions; ++times) {
    const bool deltas = contract_deltas(polynomial);
    const bool epsilons = contract_epsilons(polynomial);
    const bool rotations = contract_rotations(tree.symbols, polynomial);
    const bool units = contract_unit_vectors(tree.symbols, polynomial);
    if (!deltas && !epsilons && !rotations && !units) break;
  }
  polynomial = collected(tree, polynomial);
}

std::optional<ExprId> contracted(ExprTree& tree, ExprId id) {
  const int rank = tree[id].rank;
  if (rank > 2) return std::nullopt;
  std::vector<Slot> slots;
  std::vector<IndexId> open;
  for (int axis = 0; axis < rank; ++axis) {
    open.push_back(tree.add_index(axis == 0 ? "i" : "j"));
    slots.push_back({0, open.back()});
  }
  auto polynomial = polynomial_of(tree, id, slots);
  if (!polynomial) return std::nullopt;
  contract(tree, *polynomial);
  if (rank == 0) return as_scalar(tree, *polynomial);
  const auto whole = folded(tree, *polynomial, open);
  return whole ? std::optional(with_good_letters(tree, *whole)) : std::nullopt;
}

std::optional<ExprId> in_indices(ExprTree& tree, ExprId id) {
  auto polynomial = polynomial_of(tree, id);
  if (!polynomial) return std::nullopt;
  contract(tree, *polynomial);
  return with_good_letters(tree, expression_of(tree, *polynomial));
}

ExprId as_scalar(ExprTree& tree, const IndexPolynomial& polynomial) {
  const auto direct = folded(tree, polynomial);
  return with_good_letters(tree, direct ? *direct : expression_of(tree, polynomial));
}

}  // namespace rigor
