// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "check/scope/change_of_axes.h"

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
    rigor::define(names_.scope,
                  {{symbol, {}, no_particle, body}, {fmt::format("frame {}", rotating_), "", directive_}, 0});
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

std::optional<std::string> declare_frame(ExprTree& tree, Names& names, const std::string& rotating,
                                         const std::string& fixed, ExprId angular_velocity,
                                         std::size_t directive, Directives& used) {
  Held before = held(names.scope);
  FrameBuilder builder(tree, names, rotating, directive, tree[angular_velocity].span);
  const SymbolId rotation = builder.rotation(angular_velocity);
  const NamedDefinitions with_rotation = names.scope.definitions;
  enter_frame(names.scope, {rotating, fixed, rotation, angular_velocity, directive, 0, before});
  Turning turning{tree, names, rotation, used};
  Held after = along_turning_axes(turning, before);
  for (const NamedDefinition& each : with_rotation)
    if (!before.definitions.contains(each.definition.symbol)) after.definitions.put(each);
  std::set<SymbolId> done;
  for (const DeclaredConstant& constant : names.scope.constants) {
    const Symbol& symbol = tree.symbols[constant.symbol];
    const bool turns = symbol.rank > 0 && symbol.axes.are_common() && !symbol.rotation &&
                       !is_principal_value(names.symbols, tree.symbols, constant.symbol);
    if (turns && done.insert(constant.symbol).second)
      after.assumptions.push_back(constant_along_fixed_axes(turning, constant));
  }
  if (turning.budget.exceeded) {
    withdraw_frame(names.scope);
    replace(names.scope, std::move(before));
    return std::move(turning.budget.exceeded);
  }
  replace(names.scope, std::move(after));
  return std::nullopt;
}

void leave_frames(ExprTree& tree, Names& names, int level, Directives& used) {
  for (const Frame& frame : *names.scope.frames) {
    if (frame.depth < level) continue;
    Held behind_it = held(names.scope);
    NamedDefinitions kept;
    const auto keep = [&](const NamedDefinition& each) {
      if (!kept.contains(each.definition.symbol)) kept.put(each);
    };
    for (const NamedDefinition& each : behind_it.definitions) {
      if (!is_made_in_frame(names.scope, each)) {
        keep(each);
      } else if (auto behind = along_fixed_axes(tree, names, frame, each, used)) {
        keep(*behind);
      }
    }
    behind_it.definitions = std::move(kept);
    replace(names.scope, std::move(behind_it));
  }
}

}  // namespace rigor
