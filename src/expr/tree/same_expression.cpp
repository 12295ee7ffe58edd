// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/same_expression.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "base/among.h"
#include "expr/tree/latex_name.h"

namespace rigor {
namespace {

class Comparison {
 public:
  Comparison(const ExprTree& a, const ExprTree& b) : a_(a), b_(b) {}

  bool same(ExprId x, ExprId y) {
    if (is_zero(a_, x) || is_zero(b_, y)) return is_zero(a_, x) && is_zero(b_, y);
    if (surely_differ(x, y)) return false;
    const View left = view(a_, x);
    const View right = view(b_, y);
    if (left.op != right.op || left.rank != right.rank) return false;
    if (left.op == Op::index_sum) return same_index_sums(left.id, right.id);
    if (left.op == Op::particle_sum) return same_particle_sums(left.id, right.id);
    if (left.op == Op::multiply) return same_products(left.id, right.id);
    return same_heads(left, right) && same_slots(left.slots, right.slots) && same_children(left, right);
  }

 private:
  /// A node; the component of a lone symbol as the symbol at its slots.
  struct View {
    ExprId id{};
    Op op = Op::number;
    int rank = 0;
    std::span<const Slot> slots;
    std::span<const ExprId> children;
  };

  /// By their operations, before anything is put together.
  bool surely_differ(ExprId x, ExprId y) const {
    const ExprNode& p = a_[bare(a_, x)];
    const ExprNode& q = b_[bare(b_, y)];
    const bool components = p.op == Op::component || q.op == Op::component;
    return !components &&
           (p.op != q.op || p.rank != q.rank || (p.op == Op::symbol && !same_symbols(p.symbol, q.symbol)));
  }

  /// A written 0, or a component of one.
  static bool is_zero(const ExprTree& tree, ExprId id) {
    if (tree[id].op == Op::component) id = tree.children(id)[0];
    return tree.is_zero_literal(id);
  }

  /// The base of a first power.
  static ExprId bare(const ExprTree& tree, ExprId id) {
    while (tree[id].op == Op::power && tree[id].exponent == 1) id = tree.children(id)[0];
    return id;
  }

  static void add_factors(const ExprTree& tree, ExprId id, bool scalars, std::vector<ExprId>& factors) {
    id = bare(tree, id);
    if (tree[id].op != Op::multiply) {
      if ((tree[id].rank == 0) == scalars) factors.push_back(id);
      return;
    }
    for (const ExprId each : tree.children(id)) add_factors(tree, each, scalars, factors);
  }

  /// Scalars before vectors.
  static void add_factors(const ExprTree& tree, ExprId id, std::vector<ExprId>& factors) {
    for (const bool scalars : {true, false}) add_factors(tree, id, scalars, factors);
  }

  static View view(const ExprTree& tree, ExprId id) {
    id = bare(tree, id);
    const ExprNode& node = tree[id];
    const auto children = tree.children(id);
    if (node.op == Op::component && tree[children[0]].op == Op::symbol && tree[children[0]].slot_count == 0)
      return {children[0], Op::symbol, node.rank, tree.slots(id), {}};
    return {id, node.op, node.rank, tree.slots(id), children};
  }

  bool same_heads(const View& left, const View& right) const {
    const ExprNode& p = a_[left.id];
    const ExprNode& q = b_[right.id];
    switch (left.op) {
      case Op::number:
        return a_.digits(left.id) == b_.digits(right.id);
      case Op::symbol:
        return same_symbols(p.symbol, q.symbol) && same_particles(p.particle, q.particle);
      case Op::power:
        return p.exponent == q.exponent;
      case Op::function:
        return p.function == q.function;
      case Op::table:
        return a_.table(left.id).entry == b_.table(right.id).entry;
      default:
        return true;
    }
  }

  bool same_symbols(SymbolId p, SymbolId q) const {
    if (&a_ == &b_) return p == q;
    const Symbol& x = a_.symbols[p];
    const Symbol& y = b_.symbols[q];
    return without_face(x.name) == without_face(y.name) && x.rank == y.rank &&
           x.per_particle == y.per_particle;
  }

  bool same_particles(ParticleId p, ParticleId q) const {
    if (p == no_particle || q == no_particle) return p == q;
    const auto known = particles_.find(static_cast<std::uint32_t>(p));
    return known == particles_.end() ? a_.name(p) == b_.name(q) : known->second == q;
  }

  bool same_slots(std::span<const Slot> x, std::span<const Slot> y) const {
    return std::ranges::equal(x, y, [&](const Slot& p, const Slot& q) {
      if (p.axis != 0 || q.axis != 0) return p.axis == q.axis;
      const auto known = indices_.find(static_cast<std::uint32_t>(p.variable));
      return known == indices_.end() ? a_.name(p.variable) == b_.name(q.variable)
                                     : known->second == q.variable;
    });
  }

  bool same_children(const View& left, const View& right) {
    return std::ranges::equal(left.children, right.children, [&](ExprId p, ExprId q) { return same(p, q); });
  }

  bool same_products(ExprId x, ExprId y) {
    const std::size_t begin = factors_.size();
    add_factors(a_, x, factors_);
    const std::size_t middle = factors_.size();
    add_factors(b_, y, factors_);
    bool result = factors_.size() - middle == middle - begin;
    for (std::size_t k = begin; result && k < middle; ++k)
      result = same(factors_[k], factors_[middle + (k - begin)]);
    factors_.resize(begin);
    return result;
  }

  /// The sums around one body, in the order in which their indices occur in it.
  static std::vector<IndexId> indices_of(const ExprTree& tree, ExprId& body) {
    std::vector<IndexId> bound;
    for (; tree[body].op == Op::index_sum; body = bare(tree, tree.children(body)[0]))
      bound.push_back(tree[body].index);
    std::vector<IndexId> ordered;
    std::vector<ExprId> open{body};
    while (!open.empty()) {
      const View node = view(tree, open.back());
      open.pop_back();
      for (const Slot& slot : node.slots) {
        const bool is_bound = slot.axis == 0 && is_one_of(slot.variable, bound);
        if (is_bound && !is_one_of(slot.variable, ordered)) ordered.push_back(slot.variable);
      }
      const auto added = static_cast<std::ptrdiff_t>(open.size());
      if (node.op == Op::multiply) {
        add_factors(tree, node.id, open);
      } else {
        open.insert(open.end(), node.children.begin(), node.children.end());
      }
      std::reverse(open.begin() + added, open.end());
    }
    for (const IndexId index : bound) {
      if (!is_one_of(index, ordered)) ordered.push_back(index);
    }
    return ordered;
  }

  bool same_index_sums(ExprId x, ExprId y) {
    const std::vector<IndexId> left = indices_of(a_, x);
    const std::vector<IndexId> right = indices_of(b_, y);
    if (left.size() != right.size()) return false;
    const auto outer = indices_;
    for (std::size_t k = 0; k < left.size(); ++k) indices_[static_cast<std::uint32_t>(left[k])] = right[k];
    const bool result = same(x, y);
    indices_ = outer;
    return result;
  }

  bool same_particle_sums(ExprId x, ExprId y) {
    const auto outer = particles_;
    particles_[static_cast<std::uint32_t>(a_[x].particle)] = b_[y].particle;
    const bool result = same(a_.children(x)[0], b_.children(y)[0]);
    particles_ = outer;
    return result;
  }

  const ExprTree& a_;
  const ExprTree& b_;
  std::unordered_map<std::uint32_t, IndexId> indices_;       // bound in a, by what in b
  std::unordered_map<std::uint32_t, ParticleId> particles_;  // the same
  std::vector<ExprId> factors_;                              // of the products that are being compared
};

}  // namespace

bool same_expression(const ExprTree& a, ExprId a_root, const ExprTree& b, ExprId b_root) {
  if (&a == &b && a_root == b_root) return true;
  if (&a == &b && a[a_root].likeness != b[b_root].likeness) return false;
  return Comparison(a, b).same(a_root, b_root);
}

}  // namespace rigor
