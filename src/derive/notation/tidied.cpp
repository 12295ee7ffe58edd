// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/tidied.h"

#include <algorithm>
#include <vector>

#include "derive/notation/unfold.h"
#include "derive/polynomial/nodes.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// Recursion: as deep as the tree.
class Tidying {
 public:
  explicit Tidying(ExprTree& tree) : tree_(tree) {}

  ExprId write(ExprId id) {
    const ExprNode node = tree_[id];
    if (node.op == Op::delta || node.op == Op::epsilon) return sign(id, tree_.slots(id));
    const std::vector<ExprId> before(tree_.children(id).begin(), tree_.children(id).end());
    if (node.op == Op::component && tree_[before[0]].op == Op::basis) {
      std::vector<Slot> slots(tree_.slots(before[0]).begin(), tree_.slots(before[0]).end());
      slots.insert(slots.end(), tree_.slots(id).begin(), tree_.slots(id).end());
      return sign(id, slots);
    }
    std::vector<ExprId> after;
    for (const ExprId child : before) after.push_back(write(child));
    if (vanishes(node, before, after)) return zero_of_rank(tree_, {}, node.rank);
    if (node.op == Op::add) return terms(id, before, after);
    if (node.op == Op::multiply) return product(id, before, after);
    if (after == before) return id;
    const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
    return with_children(tree_, id, node, after, slots);
  }

 private:
  template <class Slots>
  ExprId sign(ExprId id, const Slots& slots) {
    const bool numbered = std::ranges::all_of(slots, [](const Slot& s) { return s.axis != 0; });
    if (!numbered) return id;
    if (slots.size() == 2) return number_node(tree_, slots[0].axis == slots[1].axis ? 1 : 0);
    if (slots.size() != 3) return id;
    return number_node(tree_, (slots[0].axis - slots[1].axis) * (slots[1].axis - slots[2].axis) *
                                  (slots[2].axis - slots[0].axis) / 2);
  }

  [[nodiscard]] bool became_zero(ExprId before, ExprId after) const {
    return after != before && tree_.is_zero_literal(after);
  }

  [[nodiscard]] bool vanishes(const ExprNode& node, const std::vector<ExprId>& before,
                              const std::vector<ExprId>& after) const {
    switch (node.op) {
      case Op::negate:
      case Op::divide:
      case Op::index_sum:
      case Op::particle_sum:
        return became_zero(before[0], after[0]);
      case Op::multiply:
        for (std::size_t k = 0; k < after.size(); ++k) {
          if (became_zero(before[k], after[k])) return true;
        }
        return false;
      default:
        return false;
    }
  }

  ExprId terms(ExprId id, const std::vector<ExprId>& before, const std::vector<ExprId>& after) {
    if (after == before) return id;
    std::vector<ExprId> kept;
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (!became_zero(before[k], after[k])) kept.push_back(after[k]);
    }
    return sum_node(tree_, kept, tree_[id].rank);
  }

  ExprId product(ExprId id, const std::vector<ExprId>& before, const std::vector<ExprId>& after) {
    std::vector<ExprId> factors;
    std::vector<IndexId> sums;
    for (ExprId factor : after) {
      while (tree_[factor].op == Op::index_sum) {
        const IndexId own = tree_[factor].index;
        sums.push_back(tree_.add_index(std::string(tree_.name(own))));
        factor = with_slots(tree_, tree_.children(factor)[0], {own}, {{0, sums.back()}});
      }
      if (tree_[factor].op == Op::multiply) {
        const auto inner = tree_.children(factor);
        factors.insert(factors.end(), inner.begin(), inner.end());
      } else {
        factors.push_back(factor);
      }
    }
    const auto is_one = [&](ExprId each) {
      return tree_[each].op == Op::number && tree_.digits(each) == "1";
    };
    if (factors == before && std::ranges::none_of(factors, is_one)) return id;
    const auto is_number = [&](ExprId each) { return tree_[each].op == Op::number; };
    if (std::ranges::count_if(factors, is_number) == 1)
      std::stable_partition(factors.begin(), factors.end(), is_number);
    bool negative = false;
    for (ExprId& factor : factors) {
      if (tree_[factor].op != Op::negate || !is_number(tree_.children(factor)[0])) continue;
      factor = tree_.children(factor)[0];
      negative = !negative;
    }
    ExprId all = product_node(tree_, factors);
    if (negative) all = negated_node(tree_, all);
    for (auto index = sums.rbegin(); index != sums.rend(); ++index) all = index_sum_node(tree_, *index, all);
    return all;
  }

  ExprTree& tree_;
};

}  // namespace

ExprId tidied(ExprTree& tree, ExprId root) { return Tidying(tree).write(root); }

}  // namespace rigor
