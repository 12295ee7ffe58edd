// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/answer/propose.h"

#include <array>
#include <set>
#include <utility>

#include "algebra/decide/decide.h"
#include "algebra/form/rational_form.h"
#include "base/among.h"
#include "derive/answer/coefficient.h"
#include "derive/answer/isolate.h"
#include "derive/notation/along_axes.h"
#include "derive/notation/contracted.h"
#include "derive/notation/unfold.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr Limits limits_of_proposals{.expanded_terms = 10'000,
                                     .steps = 100'000,
                                     .quick_points = 2,
                                     .sample_attempts = 40,
                                     .fewest_assumptions = false,
                                     .simplest_sample = false};
constexpr int most_unfolded = 4;

class Proposing {
 public:
  Proposing(ExprTree& tree, const HoleProblem& problem, const WantedForm& wanted)
      : tree_(tree), problem_(problem), wanted_(wanted) {}

  Proposals run() {
    if (wanted_.form == AnswerForm::contracted) proposals_.values = problem_.names;
    if (!problem_.nearly && !depends_on_hole()) {
      proposals_.impossible = outcome_of(problem_.claim) == Outcome::refuted;
      proposals_.obstacle = proposals_.impossible
                                ? "no value fits: the equation does not depend on it, and does not hold"
                                : "the equation does not depend on it";
      return std::move(proposals_);
    }
    try_numbers();
    if (!problem_.nearly) find_freedom();
    compare_coefficients();
    const Isolation isolation = isolated(tree_, problem_.claim, problem_.hole);
    if (!isolation.value) {
      proposals_.obstacle = isolation.obstacle;
    } else {
      proposals_.necessary = isolation.value;
      Equation with_it = problem_.claim;
      with_it.right = side_with(*isolation.value);
      const bool refuted = !problem_.nearly && outcome_of(with_it) == Outcome::refuted;
      if (refuted && isolation.squared) {
        proposals_.obstacle = "it is in a root: its square fits only where the other side is not negative";
        return std::move(proposals_);
      }
      proposals_.refuted_necessary = refuted;
      add_forms_of(*isolation.value);
    }
    return std::move(proposals_);
  }

 private:
  Outcome outcome_of(const Equation& claim) {
    Question question = problem_.question;
    question.tree = &tree_;
    question.claim = claim;
    return decide(question, limits_of_proposals).outcome;
  }

  ExprId side_with(ExprId value) {
    return replaced(tree_, problem_.claim.right, [&](ExprId each) -> std::optional<ExprId> {
      return tree_[each].symbol == problem_.hole ? std::optional(value) : std::nullopt;
    });
  }

  bool is_same_with(ExprId value) {
    Equation same = problem_.claim;
    same.left = side_with(value);
    same.right = side_with(zero_of_rank(tree_, tree_[value].span, tree_[value].rank));
    return outcome_of(same) == Outcome::proved;
  }

  bool depends_on_hole() {
    const ExprNode node = tree_[problem_.node];
    Symbol fresh = tree_.symbols[problem_.hole];
    fresh.name = "w";
    ExprNode other = node;
    other.symbol = tree_.symbols.add(fresh);
    const std::vector<Slot> slots(tree_.slots(problem_.node).begin(), tree_.slots(problem_.node).end());
    return !is_same_with(tree_.add(other, {}, slots));
  }

  /// Whole vectors that the claim names.
  std::vector<ExprId> vectors() const {
    std::vector<ExprId> found;
    std::set<SymbolId> known{problem_.hole};
    std::vector<ExprId> pending{problem_.claim.right, problem_.claim.left};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      const ExprNode& node = tree_[id];
      const bool one = node.particle == no_particle;  // a particle's vector belongs under its sum
      if (node.op == Op::symbol && node.rank == 1 && one && known.insert(node.symbol).second)
        found.push_back(id);
      for (const ExprId child : tree_.children(id)) pending.push_back(child);
    }
    return found;
  }

  /// 0 and 1, which forms may hide: sin² x + cos² x.
  void try_numbers() {
    const ExprNode node = tree_[problem_.node];
    if (wanted_.form != AnswerForm::contracted || node.rank > 0) return;
    for (const char* digits : {"0", "1"}) {
      const ExprId number = tree_.add_number(node.span, digits);
      Equation with_it = problem_.claim;
      with_it.right = side_with(number);
      if (outcome_of(with_it) == Outcome::proved) proposals_.values.push_back(number);
    }
  }

  /// A vector that is multiplied with others is seldom the only one.
  void find_freedom() {
    if (tree_[problem_.node].rank != 1) return;
    const std::vector<ExprId> others = vectors();
    for (const ExprId vector : others) {
      if (!is_same_with(vector)) continue;
      proposals_.may_be_added = vector;
      return;
    }
    for (const ExprId vector : others) {
      const ExprNode node = tree_[vector];
      const SymbolId any = tree_.symbols.add({.name = "\\mathbf{w}", .rank = 1, .declared = true});
      const ExprId whole = tree_.add({.op = Op::symbol, .rank = 1, .span = node.span, .symbol = any});
      const std::array factors{vector, whole};
      const ExprId product = tree_.add({.op = Op::cross, .rank = 1, .span = node.span}, factors);
      if (!is_same_with(product)) continue;
      proposals_.may_be_added = product;
      proposals_.any_vector = true;
      return;
    }
  }

  /// For a tensor at its letters; the left side is unfolded as far as needed.
  void compare_coefficients() {
    if (tree_[problem_.node].slot_count == 0) return;
    Equation claim = problem_.claim;
    for (int times = 0; times <= most_unfolded; ++times) {
      if (const auto value = coefficient_of_vectors(tree_, claim, problem_.hole)) {
        add_all(in_form(tree_, *value, wanted_));
        proposals_.values.push_back(*value);
        return;
      }
      const ExprId deeper = unfold(claim.left);
      if (deeper == claim.left) return;
      claim.left = deeper;
    }
  }

  void add_forms_of(ExprId value) {
    if (problem_.nearly && wanted_.form == AnswerForm::contracted) {
      if (const auto short_value = to_first_order(tree_, value, problem_.small))
        add_all(in_form(tree_, *short_value, wanted_));
    }
    add_all(in_form(tree_, value, wanted_));
    for (int times = 0; times < most_unfolded; ++times) {
      const ExprId deeper = unfold(value);
      if (deeper == value) break;
      value = deeper;
      add_all(in_form(tree_, value, wanted_));
    }
  }

  void add_all(const std::vector<ExprId>& values) {
    proposals_.values.insert(proposals_.values.end(), values.begin(), values.end());
  }

  /// Every defined symbol is replaced by what it stands for, once.
  ExprId unfold(ExprId value) {
    const std::vector<SymbolId> symbols = symbols_in(tree_, value);
    for (const Definition& definition : problem_.question.definitions) {
      if (is_one_of(definition.symbol, symbols)) value = unfolded(tree_, value, definition);
    }
    return value;
  }

  ExprTree& tree_;
  const HoleProblem& problem_;
  const WantedForm& wanted_;
  Proposals proposals_;
};

/// Along the axes 1, 2, 3: a scalar, or a tuple.
std::optional<ExprId> tuple_of_components(ExprTree& tree, ExprId id, std::vector<std::uint8_t> axes = {}) {
  if (static_cast<int>(axes.size()) == tree[id].rank) {
    const auto component = along_axes(tree, id, {}, axes);
    return component ? rational_form(tree, *component, RationalForm::expanded) : std::nullopt;
  }
  std::array<ExprId, 3> entries{};
  for (std::uint8_t axis = 1; axis <= 3; ++axis) {
    std::vector<std::uint8_t> deeper = axes;
    deeper.push_back(axis);
    const auto entry = tuple_of_components(tree, id, std::move(deeper));
    if (!entry) return std::nullopt;
    entries[axis - 1u] = *entry;
  }
  return tree.add({.op = Op::tuple, .rank = static_cast<std::uint8_t>(tree[entries[0]].rank + 1)}, entries);
}

/// Folded, the parts of a quotient each by itself.
std::optional<ExprId> contracted_parts(ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::divide) return contracted(tree, id);
  const std::array parts{tree.children(id)[0], tree.children(id)[1]};
  const auto above = contracted(tree, parts[0]);
  const auto below = contracted(tree, parts[1]);
  if (!above || !below) return std::nullopt;
  const std::array folded{*above, *below};
  return tree.add({.op = Op::divide, .rank = tree[*above].rank}, folded);
}

/// Folded; reduced to lowest terms where that is shorter.
void add_contracted(ExprTree& tree, ExprId id, std::vector<ExprId>& values) {
  const auto direct = contracted_parts(tree, id);
  const auto reduced = rational_form(tree, direct.value_or(id), RationalForm::expanded);
  const bool shorter = direct && reduced && tree[*reduced].weight < tree[*direct].weight;
  if (shorter) values.push_back(*reduced);
  if (direct) values.push_back(*direct);
  if (reduced && !shorter) values.push_back(*reduced);
  if (const auto indexed = tree[id].rank == 0 ? in_indices(tree, id) : std::nullopt)
    values.push_back(*indexed);
  values.push_back(id);
}

}  // namespace

std::vector<ExprId> in_form(ExprTree& tree, ExprId id, const WantedForm& wanted) {
  std::vector<ExprId> values;
  const auto add = [&](std::optional<ExprId> value) {
    if (value) values.push_back(*value);
  };
  switch (wanted.form) {
    case AnswerForm::contracted:
      add_contracted(tree, id, values);
      break;
    case AnswerForm::expanded:
      add(rational_form(tree, id, RationalForm::expanded));
      break;
    case AnswerForm::components:
      add(tuple_of_components(tree, id));
      break;
    case AnswerForm::factored:
      add(rational_form(tree, id, RationalForm::factored));
      break;
    case AnswerForm::collected:
      add(collected_by(tree, id, wanted.by));
      break;
    case AnswerForm::first_order:
      add(to_first_order(tree, id, wanted.by));
      break;
  }
  return values;
}

Proposals propose(ExprTree& tree, const HoleProblem& problem, const WantedForm& wanted) {
  return Proposing(tree, problem, wanted).run();
}

}  // namespace rigor
