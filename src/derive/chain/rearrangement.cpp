// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/rearrangement.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

#include "base/among.h"
#include "derive/chain/shape.h"

namespace rigor {
namespace {

/// What of an expression is compared.
struct Traits {
  int brackets = 0;           // sums under a product, a power, a sign or a Σ
  int quotients_of_sums = 0;  // (a + b)/c
  int quotients = 0;          // by what is no number
  int roots_in_denominators = 0;
  int terms = 0;       // wherever they stand
  int factors = 0;     // symbols, functions and roots; a power counts once
  int degree = 0;      // the same with a power n counted n times
  int under_sums = 0;  // factors under a Σ
  int lengths = 0;
  int roots = 0;
  int tuples = 0;
  std::multiset<std::string> numbers = {};
  std::multiset<std::string> products = {};  // a×b and determinants, as they are turned
  std::vector<std::string> heads = {};       // in order
  std::multiset<std::string> names = {};     // with the letters, whatever their order
  std::multiset<std::string> epsilons = {};  // in their order
  std::multiset<std::string> tensors = {};   // in their order
};

constexpr int most_times = 1000;

/// Recursion: as deep as the tree.
class Reading {
 public:
  explicit Reading(const ExprTree& tree) : tree_(tree) {}

  Traits read(ExprId root) {
    traits_.terms = tree_.is_zero_literal(root) ? 0 : 1;
    visit(root, {});
    return std::move(traits_);
  }

 private:
  struct Place {
    bool in_divisor = false;
    bool under_sum = false;
    int times = 1;
  };

  [[nodiscard]] bool is_sum(ExprId id) const {
    const Op op = tree_[id].op;
    if (op == Op::negate || op == Op::index_sum || op == Op::particle_sum)
      return is_sum(tree_.children(id)[0]);
    return op == Op::add;
  }

  [[nodiscard]] static bool brackets_sums(const ExprNode& node) {
    switch (node.op) {
      case Op::multiply:
      case Op::dot:
      case Op::cross:
      case Op::negate:
      case Op::length:
      case Op::particle_sum:
        return true;
      default:
        return node.op == Op::power && node.exponent > 1;
    }
  }

  void visit(ExprId id, const Place& place) {
    const ExprNode& node = tree_[id];
    note(id, place);
    const auto children = tree_.children(id);
    if (node.op == Op::negate && place.under_sum) ++traits_.under_sums;
    if (node.op == Op::determinant) ++traits_.brackets;
    if (node.op == Op::add) traits_.terms += static_cast<int>(children.size()) - 1;
    for (std::size_t k = 0; k < children.size(); ++k) {
      Place inner = place;
      const bool divisor = node.op == Op::divide && k == 1;
      inner.in_divisor = place.in_divisor || divisor;
      inner.under_sum = place.under_sum || node.op == Op::particle_sum;
      if (node.op == Op::power && std::abs(node.exponent) < most_times)
        inner.times *= std::abs(node.exponent);
      if (inner.times > most_times) inner.times = most_times;
      if (!divisor && brackets_sums(node) && is_sum(children[k])) ++traits_.brackets;
      visit(children[k], inner);
    }
    if (node.op == Op::divide) {
      if (tree_[children[1]].op != Op::number) ++traits_.quotients;
      if (is_sum(children[0])) ++traits_.quotients_of_sums;
    }
  }

  void count_factor(const Place& place) {
    ++traits_.factors;
    traits_.degree += place.times;
    if (place.under_sum) ++traits_.under_sums;
  }

  void note(ExprId id, const Place& place) {
    const ExprNode& node = tree_[id];
    std::string head = std::to_string(static_cast<int>(node.op)) + '.' +
                       std::to_string(static_cast<std::uint32_t>(node.symbol));
    switch (node.op) {
      case Op::number:
        traits_.numbers.insert(std::string(tree_.digits(id)));
        return;
      case Op::root:
        ++traits_.roots;
        if (place.in_divisor) ++traits_.roots_in_denominators;
        count_factor(place);
        return;
      case Op::function:
        count_factor(place);
        return;
      case Op::length:
        ++traits_.lengths;
        return;
      case Op::tuple:
        ++traits_.tuples;
        return;
      case Op::cross:
      case Op::determinant:
        traits_.products.insert(shape_of(tree_, id));
        return;
      case Op::symbol:
      case Op::delta:
      case Op::epsilon:
        break;
      default:
        return;
    }
    count_factor(place);
    std::vector<std::string> slots;
    for (const Slot& slot : tree_.slots(id))
      slots.push_back(slot.axis != 0 ? std::to_string(slot.axis) : std::string(tree_.name(slot.variable)));
    std::string letters;
    for (const std::string& slot : slots) letters += '[' + slot + ']';
    if (node.op == Op::epsilon) traits_.epsilons.insert(letters);
    if (node.op == Op::symbol) traits_.tensors.insert(head + letters);
    std::ranges::sort(slots);
    std::string sorted = head;
    for (const std::string& slot : slots) sorted += '[' + slot + ']';
    if (node.particle != no_particle) sorted += '{' + std::string(tree_.name(node.particle)) + '}';
    traits_.names.insert(std::move(sorted));
    traits_.heads.push_back(std::move(head));
  }

  const ExprTree& tree_;
  Traits traits_;
};

/// Where the same factors are on both sides.
RuleKind of_same_factors(const Traits& a, const Traits& b) {
  if (a.products != b.products) return RuleKind::products_turned;
  if (a.names == b.names) {
    if (a.epsilons != b.epsilons) return RuleKind::antisymmetric_epsilon;
    return a.tensors != b.tensors ? RuleKind::symmetric_tensor : RuleKind::order;
  }
  return a.heads == b.heads ? RuleKind::dummies_renamed : RuleKind::dummies_renamed_in_order;
}

}  // namespace

RuleKind rearrangement_of(const ExprTree& tree, ExprId before, ExprId after) {
  const Traits a = Reading(tree).read(before);
  const Traits b = Reading(tree).read(after);
  if (a.quotients_of_sums < b.quotients_of_sums) return RuleKind::common_denominator;
  if (a.quotients_of_sums > b.quotients_of_sums) return RuleKind::divided_out;
  if (a.brackets > b.brackets && a.terms <= b.terms) return RuleKind::multiplied_out;
  if (a.brackets < b.brackets && a.terms >= b.terms) return RuleKind::factored;
  if (a.terms > b.terms) return RuleKind::like_terms_collected;
  if (a.terms < b.terms) return RuleKind::terms_split;
  if (a.tuples != b.tuples) return RuleKind::components_of_tuple;
  if (a.roots_in_denominators > b.roots_in_denominators) return RuleKind::roots_out_of_denominators;
  if (a.quotients > b.quotients && a.factors > b.factors) return RuleKind::cancelled;
  if (a.lengths != b.lengths) return RuleKind::square_of_length;
  if (a.roots != b.roots) return RuleKind::squares_of_roots;
  if (a.degree < b.degree) return RuleKind::multiplied_out;
  if (a.degree > b.degree) return RuleKind::factored;
  if (a.factors > b.factors) return RuleKind::powers_joined;
  if (a.factors < b.factors) return RuleKind::powers_split;
  if (a.heads.empty() && a.numbers != b.numbers) return RuleKind::numbers_worked_out;
  if (a.under_sums > b.under_sums) return RuleKind::taken_out_of_sum;
  if (a.under_sums < b.under_sums) return RuleKind::taken_into_sum;
  return of_same_factors(a, b);
}

Rules described(const ExprTree& tree, Rules rules, ExprId before, ExprId after) {
  const RuleKind kind = rearrangement_of(tree, before, after);
  Rules words;
  for (Rule& rule : rules) {
    if (rule.kind != RuleKind::rearranged) {
      words.push_back(std::move(rule));
      continue;
    }
    const bool told = kind == RuleKind::multiplied_out || kind == RuleKind::factored ||
                      kind == RuleKind::like_terms_collected || kind == RuleKind::terms_split;
    const bool known = is_one_of(Rule{kind}, words);
    if (!known && (rules.size() == 1 || told)) words.push_back({kind});
  }
  if (words.empty()) words.push_back({kind});
  return words;
}

}  // namespace rigor
