// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/change_of_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "check/scope/covariance.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

using Slots = std::vector<Slot>;

/// What both directions share: a symbol as it is in an expression, and its derivatives.
class Axes {
 public:
  explicit Axes(Turning& turning)
      : tree_(turning.tree), names_(turning.names), used_(turning.used), budget_(turning.budget) {}

 protected:
  /// A symbol without its time derivatives; those that were taken are `orders`.
  struct Occurrence {
    SymbolId base{};
    ParticleId particle = no_particle;
    int orders = 0;
    int rank = 0;
    Slots slots;
    Span span;
  };

  Occurrence occurrence(ExprId id) const {
    const ExprNode& node = tree_[id];
    const Symbol& symbol = tree_.symbols[node.symbol];
    Occurrence result{base_of(tree_.symbols, node.symbol),
                      node.particle,
                      symbol.order(By::time),
                      symbol.rank,
                      {},
                      node.span};
    result.slots.assign(tree_.slots(id).begin(), tree_.slots(id).end());
    return result;
  }

  /// A vector or tensor: its components change with the axes.
  bool turns(SymbolId symbol) const {
    const SymbolId base = base_of(tree_.symbols, symbol);
    // A frame turns the axes of the common space.
    const Symbol& base_symbol = tree_.symbols[base];
    return base_symbol.rank > 0 && base_symbol.axes.are_common() && !base_symbol.rotation &&
           !is_principal_value(names_.symbols, tree_.symbols, base);
  }
  bool is_gradient(SymbolId symbol) const {
    return tree_.symbols[symbol].order() > tree_.symbols[symbol].order(By::time);
  }
  bool is_rate(SymbolId symbol) const { return tree_.symbols[symbol].order(By::time) > 0; }

  ExprId base(const Occurrence& of, const Slots& slots) {
    ExprNode node{.op = Op::symbol, .span = of.span, .symbol = of.base, .particle = of.particle};
    if (slots.empty()) node.rank = static_cast<std::uint8_t>(of.rank);
    return tree_.add(node, {}, slots);
  }

  ExprId rate(ExprId id) {
    const auto dependence_of = [this](SymbolId symbol) {
      const KnownChange known = change(names_, tree_, symbol, By::time);
      if (known.directive) used_.insert(*known.directive);
      return known.dependence;
    };
    Differentiator by_time(tree_, By::time, dependence_of, budget_);
    return by_time.derivative_or_zero(id);
  }

  /// The tensor whose components `at` gives.
  template <class At>
  ExprId whole(const Occurrence& of, const At& at, Slots slots = {}) {
    if (static_cast<int>(slots.size()) == of.rank) return at(slots);
    std::array<ExprId, 3> entries{};
    for (std::uint8_t axis = 1; axis <= 3; ++axis) {
      slots.push_back({axis, {}});
      entries[axis - 1u] = whole(of, at, slots);
      slots.pop_back();
    }
    const auto rank = static_cast<std::uint8_t>(of.rank - static_cast<int>(slots.size()));
    return tree_.add({.op = Op::tuple, .rank = rank, .span = of.span}, entries);
  }

  ExprId summed(ExprId id, const std::vector<IndexId>& indices) {
    for (const IndexId index : indices)
      id = tree_.add({.op = Op::index_sum, .span = tree_[id].span, .index = index}, std::span(&id, 1));
    return id;
  }
  ExprId make(Op op, ExprId a, ExprId b, std::uint8_t rank, Span span) {
    const std::array children{a, b};
    return tree_.add({.op = op, .rank = rank, .span = span}, children);
  }
  ExprId minus(ExprId id) {
    return tree_.add({.op = Op::negate, .rank = tree_[id].rank, .span = tree_[id].span}, std::span(&id, 1));
  }

  ExprTree& tree_;
  const Names& names_;
  Directives& used_;
  DerivativeBudget& budget_;
};

class ToTurning : Axes {
 public:
  explicit ToTurning(Turning& turning) : Axes(turning), rotation_(turning.rotation) {}

  Held convert(const Held& before) {
    Held after;
    for (NamedDefinition each : before.definitions) {
      if (is_rate(each.definition.symbol) && turns(each.definition.symbol)) {  // a rule
        NamedAssumption rule{as_equation(tree_, each.definition), each.origin, each.depth, each.at_instant};
        convert(rule);
        after.assumptions.push_back(std::move(rule));
        continue;
      }
      convert(each);
      after.definitions.put(std::move(each));
    }
    for (NamedAssumption each : before.assumptions) {
      convert(each);
      after.assumptions.push_back(std::move(each));
    }
    return after;
  }

  void convert(NamedAssumption& assumption) {
    Equation& equation = assumption.equation;
    const bool keeps_form = is_covariant(tree_, names_, equation.left, equation.indices) &&
                            is_covariant(tree_, names_, equation.right, equation.indices);
    const bool turned = !keeps_form && can_turn(equation.left) && can_turn(equation.right);
    assumption.at_instant = assumption.at_instant || (!keeps_form && !turned);
    equation.left = turned ? along_fixed(equation.left) : with_fixed_rates(equation.left);
    equation.right = turned ? along_fixed(equation.right) : with_fixed_rates(equation.right);
  }

 private:
  void convert(NamedDefinition& named) {
    Definition& definition = named.definition;
    const bool keeps_form = is_covariant(tree_, names_, definition.body, definition.indices);
    if (keeps_form || !can_turn(definition.body)) {
      named.at_instant = named.at_instant || !keeps_form;
      definition.body = with_fixed_rates(definition.body);
      return;
    }
    definition.body = along_fixed(definition.body);
    if (turns(definition.symbol)) turn_back(definition);
  }

  /// v_k = R_ik F_i
  void turn_back(Definition& definition) {
    const int rank = tree_.symbols[definition.symbol].rank;
    std::vector<IndexId> old = definition.indices;
    Slots at;
    if (old.empty()) {
      for (int axis = 0; axis < rank; ++axis) {
        old.push_back(tree_.add_index("i"));
        at.push_back({0, old.back()});
      }
    }
    definition.indices.clear();
    std::vector<ExprId> factors;
    for (const IndexId index : old) {
      definition.indices.push_back(tree_.add_index("k"));
      factors.push_back(rotation_at({0, index}, {0, definition.indices.back()}, tree_[definition.body].span));
    }
    factors.push_back(component_of(tree_, definition.body, at));
    const Span span = tree_[definition.body].span;
    definition.body = summed(tree_.add({.op = Op::multiply, .span = span}, factors), old);
  }

  /// Rates of vectors that stand here were taken along fixed axes.
  ExprId with_fixed_rates(ExprId root) {
    return replaced(tree_, root, [this](ExprId id) -> std::optional<ExprId> {
      const SymbolId symbol = tree_[id].symbol;
      if (!turns(symbol) || !is_rate(symbol) || is_gradient(symbol)) return std::nullopt;
      return turned_back(occurrence(id));
    });
  }

  /// The components along the fixed axes of all that stands here.
  ExprId along_fixed(ExprId root) {
    return replaced(tree_, root, [this](ExprId id) -> std::optional<ExprId> {
      if (!turns(tree_[id].symbol)) return std::nullopt;
      const Occurrence of = occurrence(id);
      return fixed(of, of.slots);
    });
  }
  bool can_turn(ExprId root) const {
    const std::vector<SymbolId> symbols = symbols_in(tree_, root);
    return std::ranges::none_of(symbols, [&](SymbolId symbol) {
      return is_gradient(symbol) || tree_.symbols[base_of(tree_.symbols, symbol)].rotation;
    });
  }

  ExprId rotation_at(Slot fixed, Slot turning, Span span) {
    const std::array slots{fixed, turning};
    return tree_.add({.op = Op::symbol, .span = span, .symbol = rotation_}, {}, slots);
  }
  ExprId rotation(Span span) {
    return tree_.add({.op = Op::symbol, .rank = 2, .span = span, .symbol = rotation_});
  }

  /// dⁿ(RA)/dtⁿ; of a tensor R_ia R_jb T_ab.
  ExprId fixed(const Occurrence& of, const Slots& slots) {
    if (of.rank > 1 && slots.empty()) return whole(of, [&](const Slots& axes) { return fixed(of, axes); });
    ExprId result{};
    if (of.rank == 1) {
      result = make(Op::dot, rotation(of.span), base(of, {}), 1, of.span);
    } else {
      std::vector<ExprId> factors;
      std::vector<IndexId> inner;
      Slots at;
      for (const Slot& slot : slots) {
        inner.push_back(tree_.add_index("a"));
        at.push_back({0, inner.back()});
        factors.push_back(rotation_at(slot, at.back(), of.span));
      }
      factors.push_back(base(of, at));
      result = summed(tree_.add({.op = Op::multiply, .span = of.span}, factors), inner);
    }
    for (int k = 0; k < of.orders; ++k) result = rate(result);
    return of.rank == 1 ? component_of(tree_, result, slots) : result;
  }

  /// The same along the turning axes: Rᵀ dⁿ(RA)/dtⁿ.
  ExprId turned_back(const Occurrence& of) { return turned_back(of, of.slots); }
  ExprId turned_back(const Occurrence& of, const Slots& slots) {
    if (of.rank == 1)
      return component_of(tree_, make(Op::dot, fixed(of, {}), rotation(of.span), 1, of.span), slots);
    if (slots.empty()) return whole(of, [&](const Slots& axes) { return turned_back(of, axes); });
    std::vector<ExprId> factors;
    std::vector<IndexId> inner;
    Slots at;
    for (const Slot& slot : slots) {
      inner.push_back(tree_.add_index("b"));
      at.push_back({0, inner.back()});
      factors.push_back(rotation_at(at.back(), slot, of.span));
    }
    factors.push_back(fixed(of, at));
    return summed(tree_.add({.op = Op::multiply, .span = of.span}, factors), inner);
  }

  SymbolId rotation_;
};

class ToFixed : Axes {
 public:
  ToFixed(Turning& turning, ExprId angular_velocity)
      : Axes(turning), rotation_(turning.rotation), velocity_(angular_velocity) {}

  /// Nothing where a derivative of R is not known here, or one is too large.
  std::optional<ExprId> convert(ExprId root) {
    const ExprId result = converted(root);
    return unknown_ || budget_.exceeded ? std::nullopt : std::optional(result);
  }

 private:
  bool is_rotation(ExprId id) const {
    return tree_[id].op == Op::symbol && base_of(tree_.symbols, tree_[id].symbol) == rotation_;
  }

  ExprId converted(ExprId id) {
    const ExprNode node = tree_[id];
    if (node.op == Op::symbol) {
      unknown_ = unknown_ || is_rotation(id) || (is_gradient(node.symbol) && is_rate(node.symbol));
      if (!turns(node.symbol) || !is_rate(node.symbol)) return id;
      const Occurrence of = occurrence(id);
      return turning_rate(of, of.slots, of.orders);
    }
    const std::vector<ExprId> before(tree_.children(id).begin(), tree_.children(id).end());
    if (node.op == Op::dot && is_rotation(before[0]))
      return turned(converted(before[1]), occurrence(before[0]).orders, 1);
    if (node.op == Op::dot && is_rotation(before[1]))
      return turned(converted(before[0]), occurrence(before[1]).orders, -1);
    std::vector<ExprId> after;
    for (const ExprId child : before) after.push_back(converted(child));
    if (after == before) return id;
    const Slots slots(tree_.slots(id).begin(), tree_.slots(id).end());
    if (node.op == Op::component) return component_of(tree_, after[0], slots);
    if (node.op == Op::table) return tree_.add_table(node.span, after, slots, Table(tree_.table(id)));
    return tree_.add(node, after, slots);
  }

  /// R⁽ⁿ⁾A (`side` 1) and Aᵀ R⁽ⁿ⁾ (−1) where R = 1: A, ±ω×A, ω×(ω×A) ± ω̇×A.
  ExprId turned(ExprId vector, int orders, int side) {
    if (tree_[vector].rank != 1 || orders > 2) {
      unknown_ = true;
      return vector;
    }
    const auto signed_by = [&](ExprId id) { return side > 0 ? id : minus(id); };
    if (orders == 0) return vector;
    if (orders == 1) return signed_by(cross(velocity_, vector));
    const ExprId twice = cross(velocity_, cross(velocity_, vector));
    return make(Op::add, twice, signed_by(cross(rate(velocity_), vector)), 1, tree_[vector].span);
  }
  ExprId cross(ExprId a, ExprId b) { return make(Op::cross, a, b, 1, tree_[b].span); }

  /// Along the turning axes: (d/dt − ω×)ⁿ A; of a tensor, −ε_sab ω_a T_b for each axis s.
  ExprId turning_rate(const Occurrence& of, const Slots& slots, int orders) {
    if (of.rank == 1) {
      ExprId vector = base(of, {});
      for (int k = 0; k < orders; ++k)
        vector = make(Op::add, rate(vector), minus(cross(velocity_, vector)), 1, of.span);
      return component_of(tree_, vector, slots);
    }
    if (slots.empty()) return whole(of, [&](const Slots& axes) { return turning_rate(of, axes, orders); });
    if (orders == 0) return base(of, slots);
    std::vector<ExprId> terms{rate(turning_rate(of, slots, orders - 1))};
    for (std::size_t axis = 0; axis < slots.size(); ++axis) {
      const IndexId a = tree_.add_index("a");
      const IndexId b = tree_.add_index("b");
      Slots other = slots;
      other[axis] = {0, b};
      const std::array sign{slots[axis], Slot{0, a}, Slot{0, b}};
      const Slot along{0, a};
      const std::array factors{tree_.add({.op = Op::epsilon, .span = of.span}, {}, sign),
                               component_of(tree_, velocity_, std::span(&along, 1)),
                               turning_rate(of, other, orders - 1)};
      terms.push_back(minus(summed(tree_.add({.op = Op::multiply, .span = of.span}, factors), {a, b})));
    }
    return tree_.add({.op = Op::add, .span = of.span}, terms);
  }

  SymbolId rotation_;
  ExprId velocity_;
  bool unknown_ = false;
};

}  // namespace

Held along_turning_axes(Turning& turning, const Held& before) { return ToTurning(turning).convert(before); }

NamedAssumption constant_along_fixed_axes(Turning& turning, const DeclaredConstant& constant) {
  ExprTree& tree = turning.tree;
  const Symbol symbol = tree.symbols[constant.symbol];
  NamedAssumption steady;
  steady.origin = {fmt::format("constant {}", symbol.name), "", constant.directive};
  steady.depth = constant.depth;
  steady.rate_of = constant.symbol;
  Definition rule{.symbol = tree.symbols.derivative(constant.symbol, By::time),
                  .body = tree.add_number(symbol.first_seen, "0")};
  for (int axis = 0; axis < symbol.rank; ++axis) rule.indices.push_back(tree.add_index("i"));
  if (symbol.per_particle) rule.particle = tree.add_particle("p");
  steady.equation = as_equation(tree, rule);
  ToTurning(turning).convert(steady);
  return steady;
}

std::optional<NamedDefinition> along_fixed_axes(ExprTree& tree, const Names& names, const Frame& frame,
                                                NamedDefinition made, Directives& used) {
  Definition& definition = made.definition;
  Turning turning{tree, names, frame.rotation, used};
  const auto body = ToFixed(turning, frame.angular_velocity).convert(definition.body);
  if (!body) return std::nullopt;
  made.at_instant = made.at_instant || !is_covariant(tree, names, definition.body, definition.indices);
  definition.body = *body;
  return made;
}

}  // namespace rigor
