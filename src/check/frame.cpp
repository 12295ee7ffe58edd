// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rigor {
namespace {

/// Builds the definitions behind a frame.
class FrameBuilder {
 public:
  FrameBuilder(ExprTree& tree, Names& names, std::string rotating, std::size_t directive, Span span)
      : tree_(tree), names_(names), rotating_(std::move(rotating)), directive_(directive), span_(span) {}

  SymbolId rotation(ExprId angular_velocity) {
    for (std::size_t k = 0; k < 4; ++k) {
      q_[k] = tree_.symbols.add({.name = fmt::format("q_{}", k), .declared = true});
      define(q_[k], tree_.add_number(span_, k == 0 ? "1" : "0"));
    }
    for (std::size_t k = 0; k < 4; ++k)
      define(tree_.symbols.derivative(q_[k], By::time), rate(k, angular_velocity));
    Symbol symbol{.name = fmt::format("R_{{\\text{{{}}}}}", rotating_), .rank = 2, .declared = true};
    const SymbolId rotation = tree_.symbols.add(std::move(symbol));
    define(rotation, matrix());
    return rotation;
  }

 private:
  void define(SymbolId symbol, ExprId body) {
    names_.define({{symbol, {}, no_particle, body}, {fmt::format("frame {}", rotating_), "", directive_}, 0});
  }

  ExprId q(std::size_t k) { return tree_.add({.op = Op::symbol, .span = span_, .symbol = q_[k]}); }
  ExprId product(std::vector<ExprId> factors) {
    return tree_.add({.op = Op::multiply, .span = span_}, factors);
  }
  ExprId sum(std::vector<ExprId> terms) { return tree_.add({.op = Op::add, .span = span_}, terms); }
  ExprId minus(ExprId term) { return tree_.add({.op = Op::negate, .span = span_}, std::span(&term, 1)); }
  ExprId number(const char* digits) { return tree_.add_number(span_, digits); }
  ExprId over(ExprId above, ExprId below) {
    const std::array parts{above, below};
    return tree_.add({.op = Op::divide, .span = span_}, parts);
  }
  ExprId velocity(ExprId vector, std::size_t axis) {
    const Slot slot{static_cast<std::uint8_t>(axis), {}};
    return component_of(tree_, vector, std::span(&slot, 1));
  }

  /// q' = q ω/2: q_0' = −q·ω/2 and q_i' = (q_0 ω_i + q_j ω_k − q_k ω_j)/2 for cyclic (i, j, k).
  ExprId rate(std::size_t i, ExprId w) {
    if (i == 0) {
      std::vector<ExprId> terms;
      for (std::size_t k = 1; k <= 3; ++k) terms.push_back(product({q(k), velocity(w, k)}));
      return minus(over(sum(terms), number("2")));
    }
    const std::size_t j = i % 3 + 1;
    const std::size_t k = j % 3 + 1;
    const ExprId twice = sum({product({q(0), velocity(w, i)}), product({q(j), velocity(w, k)}),
                              minus(product({q(k), velocity(w, j)}))});
    return over(twice, number("2"));
  }

  ExprId matrix() {
    std::vector<ExprId> rows;
    for (std::size_t i = 1; i <= 3; ++i) {
      std::vector<ExprId> row;
      for (std::size_t j = 1; j <= 3; ++j) row.push_back(over(entry(i, j), squares(1)));
      rows.push_back(tree_.add({.op = Op::tuple, .rank = 1, .span = span_}, row));
    }
    return tree_.add({.op = Op::tuple, .rank = 2, .span = span_}, rows);
  }

  /// q_0² ± q·q
  ExprId squares(int sign) {
    std::vector<ExprId> terms;
    for (std::size_t k = 0; k < 4; ++k) {
      const ExprId square = product({q(k), q(k)});
      terms.push_back(k > 0 && sign < 0 ? minus(square) : square);
    }
    return sum(terms);
  }

  ExprId entry(std::size_t i, std::size_t j) {
    const ExprId symmetric = product({number("2"), q(i), q(j)});
    if (i == j) return sum({squares(-1), symmetric});
    const std::size_t k = 6 - i - j;
    const ExprId skew = product({number("2"), q(0), q(k)});
    const bool cyclic = i % 3 + 1 == j;  // ε_ijk = 1
    return sum({symmetric, cyclic ? minus(skew) : skew});
  }

  ExprTree& tree_;
  Names& names_;
  std::string rotating_;
  std::size_t directive_;
  Span span_;
  std::array<SymbolId, 4> q_{};
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
      const bool along_fixed_axes =
          names_an_axis(tree_, each.equation.left) || names_an_axis(tree_, each.equation.right);
      each.at_instant = each.at_instant || along_fixed_axes;
      each.equation.left = converted(each.equation.left);
      each.equation.right = converted(each.equation.right);
      after.assumptions.push_back(std::move(each));
    }
    return after;
  }

  [[nodiscard]] const std::optional<std::string>& too_large() const { return budget_.exceeded; }

 private:
  bool is_vectors_rate(SymbolId symbol) const {
    const auto& derivation = tree_.symbols[symbol].derivation;
    return derivation && derivation->time > 0 && tree_.symbols[derivation->base].rank > 0;
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
    const auto dependence_of = [this](SymbolId symbol) { return names_.dependence(tree_, symbol, By::time); };
    Differentiator by_time(tree_, By::time, dependence_of, budget_);
    const std::array back{by_time.derivative_or_zero(fixed), rotation};
    return tree_.add({.op = Op::dot, .rank = 1, .span = span}, back);
  }

  ExprTree& tree_;
  Names& names_;
  SymbolId rotation_;
  DerivativeBudget budget_;
};

}  // namespace

std::optional<std::string> declare_frame(ExprTree& tree, Names& names, const std::string& rotating,
                                         const std::string& fixed, ExprId angular_velocity,
                                         std::size_t directive) {
  Names::Scene before = names.scene();
  FrameBuilder builder(tree, names, rotating, directive, tree[angular_velocity].span);
  const SymbolId rotation = builder.rotation(angular_velocity);
  FixedRates rates(tree, names, rotation);
  Names::Scene after = rates.convert(before);
  if (const auto& why = rates.too_large()) {
    names.replace(std::move(before));
    return why;
  }
  for (const NamedDefinition& each : names.definitions()) {
    const auto own = [&](const NamedDefinition& old) {
      return old.definition.symbol == each.definition.symbol;
    };
    if (std::none_of(before.definitions.begin(), before.definitions.end(), own))
      after.definitions.push_back(each);
  }
  names.replace(std::move(after));
  names.declare_frame({rotating, fixed, rotation, directive, 0}, std::move(before));
  return std::nullopt;
}

}  // namespace rigor
