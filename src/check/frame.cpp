// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rigor {
namespace {

/// Builds the definitions behind a frame: R = 1, and Ṙ.
class FrameBuilder {
 public:
  FrameBuilder(ExprTree& tree, Names& names, std::string rotating, std::size_t directive, Span span)
      : tree_(tree), names_(names), rotating_(std::move(rotating)), directive_(directive), span_(span) {}

  SymbolId rotation(ExprId angular_velocity) {
    Symbol symbol{.name = fmt::format("R_{{\\text{{{}}}}}", rotating_), .rank = 2, .declared = true};
    rotation_ = tree_.symbols.add(std::move(symbol));
    define(rotation_, matrix([&](std::uint8_t i, std::uint8_t j) {
             return tree_.add_number(span_, i == j ? "1" : "0");
           }));
    define(tree_.symbols.derivative(rotation_, By::time),
           matrix([&](std::uint8_t i, std::uint8_t j) { return rate(i, j, angular_velocity); }));
    return rotation_;
  }

 private:
  void define(SymbolId symbol, ExprId body) {
    names_.define({{symbol, {}, no_particle, body}, {fmt::format("frame {}", rotating_), "", directive_}, 0});
  }

  template <class Entry>
  ExprId matrix(const Entry& entry) {
    std::array<ExprId, 3> rows{};
    for (std::uint8_t i = 1; i <= 3; ++i) {
      const std::array row{entry(i, 1), entry(i, 2), entry(i, 3)};
      rows[i - 1u] = tree_.add({.op = Op::tuple, .rank = 1, .span = span_}, row);
    }
    return tree_.add({.op = Op::tuple, .rank = 2, .span = span_}, rows);
  }

  /// Ṙ_ij = −R_il ε_ljk ω_k = R_ik ω_l − R_il ω_k for cyclic (j, k, l).
  ExprId rate(std::uint8_t i, std::uint8_t j, ExprId w) {
    const auto k = static_cast<std::uint8_t>(j % 3 + 1);
    const auto l = static_cast<std::uint8_t>(k % 3 + 1);
    const ExprId second = product(i, l, w, k);
    const std::array terms{product(i, k, w, l),
                           tree_.add({.op = Op::negate, .span = span_}, std::span(&second, 1))};
    return tree_.add({.op = Op::add, .span = span_}, terms);
  }

  /// R_ij ω_k
  ExprId product(std::uint8_t i, std::uint8_t j, ExprId w, std::uint8_t k) {
    const std::array places{Slot{i, {}}, Slot{j, {}}};
    const Slot axis{k, {}};
    const std::array factors{tree_.add({.op = Op::symbol, .span = span_, .symbol = rotation_}, {}, places),
                             component_of(tree_, w, std::span(&axis, 1))};
    return tree_.add({.op = Op::multiply, .span = span_}, factors);
  }

  ExprTree& tree_;
  Names& names_;
  std::string rotating_;
  std::size_t directive_;
  Span span_;
  SymbolId rotation_{};
};

}  // namespace

namespace {

/// Vectors' rates that were written before were taken along fixed axes: Rᵀ d(R A)/dt with components along
/// the turning ones.
class FixedRates {
 public:
  FixedRates(ExprTree& tree, Names& names, SymbolId rotation)
      : tree_(tree), names_(names), rotation_(rotation) {}

  Names::Scene convert(const Names::Scene& before) {
    Names::Scene after;
    for (NamedDefinition each : before.definitions) {
      if (is_vectors_rate(each.definition.symbol)) {  // a rule
        after.assumptions.push_back(as_assumption(each));
        continue;
      }
      each.definition.body = converted(each.definition.body);
      after.definitions.push_back(std::move(each));
    }
    for (NamedAssumption each : before.assumptions) {
      each.at_instant = each.at_instant || names_axes(each.equation.left) || names_axes(each.equation.right);
      each.equation.left = converted(each.equation.left);
      each.equation.right = converted(each.equation.right);
      after.assumptions.push_back(std::move(each));
    }
    return after;
  }

 private:
  bool is_vectors_rate(SymbolId symbol) const {
    const auto& derivation = tree_.symbols[symbol].derivation;
    return derivation && derivation->time > 0 && tree_.symbols[derivation->base].rank > 0;
  }

  /// Is something said along an axis? Then it is one of the fixed axes.
  bool names_axes(ExprId root) const {
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      if (tree_[id].op == Op::basis) return true;
      for (const Slot& slot : tree_.slots(id)) {
        if (slot.axis != 0) return true;
      }
      for (const ExprId child : tree_.children(id)) pending.push_back(child);
    }
    return false;
  }

  NamedAssumption as_assumption(const NamedDefinition& rule) {
    const Definition& definition = rule.definition;
    ExprNode node{.op = Op::symbol, .span = tree_[definition.body].span, .symbol = definition.symbol};
    node.particle = definition.particle;
    NamedAssumption assumption;
    assumption.origin = rule.origin;
    assumption.depth = rule.depth;
    std::vector<Slot> slots;
    for (const IndexId index : definition.indices) slots.push_back({0, index});
    node.rank =
        slots.empty() ? static_cast<std::uint8_t>(tree_.symbols[definition.symbol].rank) : std::uint8_t{0};
    assumption.equation.left = converted(tree_.add(node, {}, slots));
    assumption.equation.right = converted(definition.body);
    assumption.equation.indices = definition.indices;
    if (definition.particle != no_particle) assumption.equation.particles.push_back(definition.particle);
    return assumption;
  }

  ExprId converted(ExprId root) {
    return replaced(tree_, root, [this](ExprId id) -> std::optional<ExprId> {
      const ExprNode node = tree_[id];
      if (!is_vectors_rate(node.symbol)) return std::nullopt;
      const Derivation derivation = *tree_.symbols[node.symbol].derivation;
      if (tree_.symbols[derivation.base].rank > 1 || derivation.space > 0 || derivation.small > 0)
        return std::nullopt;
      const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
      ExprNode base{.op = Op::symbol, .rank = 1, .span = node.span, .symbol = derivation.base};
      base.particle = node.particle;
      ExprId vector = tree_.add(base);
      for (int k = 0; k < derivation.time; ++k) vector = rate_along_fixed_axes(vector);
      return component_of(tree_, vector, slots);
    });
  }

  ExprId rate_along_fixed_axes(ExprId vector) {
    const Span span = tree_[vector].span;
    const ExprId rotation = tree_.add({.op = Op::symbol, .rank = 2, .span = span, .symbol = rotation_});
    const std::array turned{rotation, vector};
    const ExprId fixed = tree_.add({.op = Op::dot, .rank = 1, .span = span}, turned);
    Differentiator by_time(tree_, By::time,
                           [this](SymbolId symbol) { return names_.dependence(tree_, symbol, By::time); });
    const std::array back{by_time.derivative_or_zero(fixed), rotation};
    return tree_.add({.op = Op::dot, .rank = 1, .span = span}, back);
  }

  ExprTree& tree_;
  Names& names_;
  SymbolId rotation_;
};

}  // namespace

void declare_frame(ExprTree& tree, Names& names, const std::string& rotating, const std::string& fixed,
                   ExprId angular_velocity, std::size_t directive) {
  Names::Scene before = names.scene();
  FrameBuilder builder(tree, names, rotating, directive, tree[angular_velocity].span);
  const SymbolId rotation = builder.rotation(angular_velocity);
  Names::Scene after = FixedRates(tree, names, rotation).convert(before);
  for (const NamedDefinition& each : names.definitions()) {
    const auto own = [&](const NamedDefinition& old) {
      return old.definition.symbol == each.definition.symbol;
    };
    if (std::none_of(before.definitions.begin(), before.definitions.end(), own))
      after.definitions.push_back(each);
  }
  names.replace(std::move(after));
  names.declare_frame({rotating, fixed, rotation, directive, 0}, std::move(before));
}

}  // namespace rigor
