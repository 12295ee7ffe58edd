// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/space_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elaborate/reading/change.h"
#include "elaborate/reading/summation.h"

namespace rigor {
namespace {

const SpaceTime& shown(const Reading& reading) { return reading.names.symbols.evidence->space_time; }

ExprId negated(ExprTree& tree, ExprId id, Span span) {
  return tree.add({.op = Op::negate, .rank = tree[id].rank, .span = span}, std::span(&id, 1));
}

/// c, which does not change; nothing where it is 1.
std::optional<ExprId> speed_of_light(Reading& reading, Span span) {
  if (shown(reading).unit_speed) return std::nullopt;
  const SymbolId symbol = symbol_named(reading, {"c", 0, false}, "c", span);
  if (!is_declared_constant(reading.names.scope, symbol))
    declare_constant(reading.names.scope, symbol, std::nullopt);
  return reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
}

bool is_coordinate_of_event(const ExprTree& tree, const ExprNode& node) {
  const Symbol& symbol = tree.symbols[node.symbol];
  return symbol.name == "x" && symbol.rank == 1 && symbol.axes[0] == space_time && !symbol.derivation &&
         node.slot_count == 1;
}

std::optional<ExprId> derivative_of_symbol(Reading& reading, ExprId id, const Slot& slot);

/// Of a whole vector: the tuple of the derivatives of its components.
std::optional<ExprId> derivative_of_whole(Reading& reading, ExprId id, const Slot& slot) {
  ExprTree& tree = reading.tree;
  const ExprNode node = tree[id];
  const Space space = node.axes[0];
  std::vector<ExprId> entries;
  for (std::uint8_t axis = 1; axis <= space.dimension; ++axis) {
    const Slot along{axis, {}};
    const ExprId part = component_of(tree, id, std::span(&along, 1));
    const auto changed = derivative_of_symbol(reading, part, slot);
    entries.push_back(changed ? *changed : tree.add_number(node.span, "0"));
  }
  return tree.add({.op = Op::tuple, .rank = 1, .span = node.span, .axes = AxisSpaces::of(space, 1)}, entries);
}

/// (∂_t, ∂_x, ∂_y, ∂_z) of one symbol, at the slot; nothing where it is zero.
std::optional<ExprId> derivative_of_symbol(Reading& reading, ExprId id, const Slot& slot) {
  ExprTree& tree = reading.tree;
  const ExprNode node = tree[id];
  if (node.rank == 1) return derivative_of_whole(reading, id, slot);
  if (is_coordinate_of_event(tree, node)) {
    const std::array<Slot, 2> slots{tree.slots(id)[0], slot};
    return tree.add({.op = Op::delta, .span = node.span}, {}, slots);
  }
  const Symbol& symbol = tree.symbols[node.symbol];
  if (symbol.circle_number || symbol.name == shown(reading).metric + "_{00}" || symbol.name == "c")
    return std::nullopt;
  const Typed typed{.id = id, .rank = node.rank};
  std::vector<ExprId> entries;
  std::vector<SymbolId>& unknown = reading.found.unknown_changes;
  const std::size_t unknown_before = unknown.size();
  ExprId rate = rate_of(reading, typed, 1, true).id;
  if (const auto c = tree.is_zero_literal(rate) ? std::nullopt : speed_of_light(reading, node.span)) {
    const std::array<ExprId, 2> parts{rate, *c};
    rate = tree.add({.op = Op::divide, .rank = node.rank, .span = node.span}, parts);
  }
  entries.push_back(rate);
  const std::size_t unknown_by_time = unknown.size();
  for (std::uint8_t axis = 1; axis <= 3; ++axis) entries.push_back(derivative_along(reading, id, {axis, {}}));
  if (unknown.size() == unknown_by_time) unknown.resize(unknown_before);  // a field changes in time as well
  if (std::ranges::all_of(entries, [&](ExprId each) { return tree.is_zero_literal(each); }))
    return std::nullopt;
  const ExprId whole = tree.add({.op = Op::tuple,
                                 .rank = static_cast<std::uint8_t>(node.rank + 1),
                                 .span = node.span,
                                 .axes = AxisSpaces::of(space_time, 1)},
                                entries);
  return component_of(tree, whole, std::span(&slot, 1));
}

/// The same value, whose axes are those of space-time.
std::optional<ExprId> in_space_time(ExprTree& tree, ExprId id) {
  const ExprNode node = tree[id];
  for (int axis = 0; axis < node.rank; ++axis) {
    if (node.axes[axis].dimension != space_time.dimension) return std::nullopt;
  }
  if (node.axes == AxisSpaces::of(space_time, node.rank)) return id;
  if (node.op != Op::tuple) return std::nullopt;
  std::vector<ExprId> entries;
  const std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  for (const ExprId child : children) {
    const auto entry = node.rank > 1 ? in_space_time(tree, child) : std::optional(child);
    if (!entry) return std::nullopt;
    entries.push_back(*entry);
  }
  return tree.add(
      {.op = Op::tuple, .rank = node.rank, .span = node.span, .axes = AxisSpaces::of(space_time, 1)},
      entries);
}

}  // namespace

ExprId metric_sign(Reading& reading, Span span) {
  ExprTree& tree = reading.tree;
  const std::set<int>& signs = shown(reading).signs;
  if (signs.size() == 1) {
    const ExprId one = tree.add_number(span, "1");
    return *signs.begin() > 0 ? one : negated(tree, one, span);
  }
  const std::string name = shown(reading).metric + "_{00}";
  const SymbolId symbol = symbol_named(reading, {name, 0, false}, name, span);
  if (!is_declared_constant(reading.names.scope, symbol))
    declare_constant(reading.names.scope, symbol, std::nullopt);
  tree.symbols.write(symbol).declared = true;  // a number, and no matrix
  const ExprId number = tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
  const ExprId length = tree.add({.op = Op::absolute, .span = span}, std::span(&number, 1));
  const std::array<ExprId, 2> parts{number, length};
  return tree.add({.op = Op::divide, .span = span}, parts);
}

ExprId signature_at(Reading& reading, const Slot& slot, Span span) {
  ExprTree& tree = reading.tree;
  const ExprId sign = metric_sign(reading, span);
  const bool negative = tree[sign].op == Op::negate;
  const ExprId opposite = negative ? tree.children(sign)[0] : negated(tree, sign, span);
  if (slot.axis != 0) return slot.axis == 1 ? sign : opposite;
  const std::array<ExprId, 2> values{sign, opposite};
  return tree.add_table(span, values, std::span(&slot, 1), {{0, 1, 1, 1}});
}

ExprId turned_at(Reading& reading, ExprId value, const Slot& slot, Span span) {
  ExprTree& tree = reading.tree;
  const ExprId factor = signature_at(reading, slot, span);
  if (tree[factor].op == Op::number) return value;
  if (tree[factor].op == Op::negate && tree[tree.children(factor)[0]].op == Op::number)
    return tree[value].op == Op::negate ? tree.children(value)[0] : negated(tree, value, span);
  const std::array<ExprId, 2> factors{factor, value};
  return tree.add({.op = Op::multiply, .rank = tree[value].rank, .span = span}, factors);
}

ExprId derivative_by_event(Reading& reading, ExprId id, const Slot& slot) {
  const auto constant = [](SymbolId) { return Dependence{}; };
  Differentiator differentiate(reading.tree, By::space, constant, reading.derivatives.budget, slot,
                               [&](ExprId symbol) { return derivative_of_symbol(reading, symbol, slot); });
  return differentiate.derivative_or_zero(id);
}

std::optional<Slot> event_slot(Reading& reading, const WrittenIndex& index, const Around& around,
                               std::vector<FreeIndex>& free) {
  if (index.form == IndexForm::digit) {
    if (index.text.size() != 1 || index.text[0] < '0' || index.text[0] > '3') return std::nullopt;
    return Slot{static_cast<std::uint8_t>(index.text[0] - '0' + 1), {}};
  }
  if (const auto fixed = around.axes.find(index.text); fixed != around.axes.end())
    return Slot{fixed->second, {}};
  const IndexId id = index_named(reading, index.text, space_time);
  if (reading.tree.space(id) != space_time) return std::nullopt;  // `i` runs over the axes of space here
  const Height height = index.raised ? Height::above : Height::below;
  if (!reading.indices.summed.contains(index.text))
    free.push_back({index.text, id, index.span, false, height});
  return Slot{0, id};
}

MaybeTyped by_event(Reading& reading, const Typed& operand, const WrittenIndex& index, Span span,
                    const Around& around) {
  if (shown(reading).curved && operand.rank > 0)
    return unsupported(reading, span, "a derivative of a whole tensor is not decided");
  std::vector<FreeIndex> free;
  const auto slot = event_slot(reading, index, around, free);
  if (!slot || operand.layout != Layout::none || operand.rank > 0)
    return unsupported(reading, span, "such a derivative in space-time is not decided");
  auto letters = contraction_of(reading, {{.free = free}, operand});
  if (!letters) return std::nullopt;
  Typed typed{.rank = operand.rank, .particles = operand.particles};
  typed.id = derivative_by_event(reading, operand.id, *slot);
  if (index.raised && !reading.tree.is_zero_literal(typed.id))
    typed.id = turned_at(reading, typed.id, *slot, span);
  return summed(reading.tree, std::move(typed), *std::move(letters));
}

MaybeTyped box_of(Reading& reading, const Typed& operand, Span span) {
  if (operand.rank > 0) return unsupported(reading, span, "such a derivative in space-time is not decided");
  ExprTree& tree = reading.tree;
  const Slot slot{0, tree.add_index("\\mu", space_time)};
  Typed typed = operand;
  typed.id = turned_at(reading, derivative_by_event(reading, operand.id, slot), slot, span);
  typed.id = derivative_by_event(reading, typed.id, slot);
  typed.id = tree.add({.op = Op::index_sum,
                       .rank = static_cast<std::uint8_t>(typed.rank),
                       .span = span,
                       .index = slot.variable},
                      std::span(&typed.id, 1));
  return typed;
}

void match_components(Reading& reading, Typed& one, Typed& other) {
  const auto is_of_event = [](const Typed& typed) {
    return typed.rank == 0 && !typed.free.empty() &&
           std::ranges::all_of(typed.free, [](const FreeIndex& free) { return free.height != Height::none; });
  };
  if (!is_of_event(one)) {
    if (is_of_event(other)) match_components(reading, other, one);
    return;
  }
  if (!other.free.empty() || other.rank != static_cast<int>(one.free.size())) return;
  const auto whole = in_space_time(reading.tree, other.id);
  if (!whole) return;
  std::vector<Slot> slots;
  for (const FreeIndex& free : one.free) slots.push_back({0, free.id});
  other.id = component_of(reading.tree, *whole, slots);
  other.rank = 0;
  other.layout = Layout::none;
  other.with_unit.reset();
  other.free = one.free;
}

}  // namespace rigor
