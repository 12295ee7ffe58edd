// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/tree.h"

#include <algorithm>
#include <utility>

#include "base/ascii.h"
#include "base/check.h"
#include "expr/tree/marks.h"

namespace rigor {
namespace {

constexpr std::uint32_t any_count = 0xffffffffu;

/// How many children and slots an operation takes.
struct Shape {
  std::uint32_t children = 0;
  std::uint32_t slots = 0;
};

[[nodiscard]] Shape shape_of(Op op) {
  switch (op) {
    case Op::number:
      return {};
    case Op::symbol:
      return {0, any_count};
    case Op::basis:
      return {0, 1};
    case Op::delta:
      return {0, 2};
    case Op::epsilon:
      return {0, 3};
    case Op::add:
      return {any_count, 0};
    case Op::negate:
      return {1, 0};
    case Op::multiply:
      return {any_count, 0};
    case Op::divide:
    case Op::real_power:
      return {2, 0};
    case Op::power:
      return {1, 0};
    case Op::root:
      return {1, 0};
    case Op::length:
      return {1, 0};
    case Op::absolute:
      return {1, 0};
    case Op::dot:
      return {2, 0};
    case Op::cross:
      return {2, 0};
    case Op::component:
      return {1, any_count};
    case Op::tuple:
      return {any_count, 0};  // as many as its first axis has dimensions, see check_axes
    case Op::determinant:
      return {9, 0};
    case Op::imaginary_unit:
      return {};
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::index_sum:
      return {1, 0};
    case Op::particle_sum:
    case Op::function:
    case Op::transpose:
      return {1, 0};
    case Op::trace:
    case Op::matrix_determinant:
      return {any_count, 0};  // one or two
    case Op::table:
      return {any_count, any_count};
  }
  return {};
}

[[nodiscard]] bool all_of_rank(std::span<const int> ranks, int rank) {
  return std::ranges::all_of(ranks, [rank](int each) { return each == rank; });
}

[[nodiscard]] int sum_of(std::span<const int> ranks) {
  int sum = 0;
  for (const int each : ranks) sum += each;
  return sum;
}

constexpr int no_rank = -1;

/// Nine children: all scalars, or one row of vectors (`e_1, e_2, e_3`, say) and six scalars.
[[nodiscard]] int rank_of_determinant(std::span<const int> ranks) {
  if (all_of_rank(ranks, 0)) return 0;
  for (std::size_t row = 0; row < 9; row += 3) {
    if (all_of_rank(ranks.subspan(row, 3), 1) && sum_of(ranks) == 3) return 1;
  }
  return no_rank;
}

/// The rank that an operation gives for children of these ranks (the counts fit), or no_rank.
[[nodiscard]] int rank_of(Op op, std::span<const int> ranks, std::uint32_t slots) {
  switch (op) {
    case Op::number:
    case Op::delta:
    case Op::epsilon:
    case Op::imaginary_unit:
      return 0;
    case Op::basis:
      return 1;
    case Op::add:
    case Op::table:
      return !ranks.empty() && all_of_rank(ranks, ranks[0]) ? ranks[0] : no_rank;
    case Op::negate:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::index_sum:
    case Op::particle_sum:
      return ranks[0];
    case Op::multiply:
      return ranks.empty() ? no_rank : sum_of(ranks);
    case Op::divide:
      return ranks[1] == 0 ? ranks[0] : no_rank;
    case Op::real_power:
      return all_of_rank(ranks, 0) ? 0 : no_rank;
    case Op::power:
    case Op::root:
    case Op::absolute:
    case Op::function:
    case Op::transpose:
      return ranks[0] == 0 ? 0 : no_rank;
    case Op::trace:
    case Op::matrix_determinant:
      return !ranks.empty() && ranks.size() <= 2 && all_of_rank(ranks, 0) ? 0 : no_rank;
    case Op::length:
      return ranks[0] == 1 ? 0 : no_rank;
    case Op::dot:
      return ranks[0] > 0 && ranks[1] > 0 ? sum_of(ranks) - 2 : no_rank;
    case Op::cross:
      return all_of_rank(ranks, 1) ? 1 : no_rank;
    case Op::component:
      return slots > 0 && ranks[0] == static_cast<int>(slots) ? 0 : no_rank;
    case Op::tuple:
      return !ranks.empty() && all_of_rank(ranks, ranks[0]) ? ranks[0] + 1 : no_rank;
    case Op::determinant:
      return rank_of_determinant(ranks);
    case Op::symbol:
      return no_rank;  // depends on the symbol, see check_symbol
  }
  return no_rank;
}

void check_symbol(const SymbolTable& symbols, const ExprNode& node) {
  RIGOR_CHECK(static_cast<std::size_t>(node.symbol) < symbols.size(),
              static_cast<std::uint32_t>(node.symbol));
  const Symbol& symbol = symbols[node.symbol];
  const bool whole = node.slot_count == 0;
  RIGOR_CHECK(whole || static_cast<int>(node.slot_count) == symbol.rank, symbol.name, symbol.rank,
              node.slot_count);
  RIGOR_CHECK(static_cast<int>(node.rank) == (whole ? symbol.rank : 0), symbol.name, symbol.rank, node.rank);
  RIGOR_CHECK((node.particle != no_particle) == symbol.per_particle, symbol.name);
}

[[nodiscard]] bool is_decimal(std::string_view digits) {
  return std::ranges::count(digits, '.') <= 1 &&
         std::ranges::any_of(digits, [](char c) { return is_digit(c); }) &&
         std::ranges::all_of(digits, [](char c) { return c == '.' || is_digit(c); });
}

}  // namespace

IndexId ExprTree::add_index(std::string name, Space space) {
  RIGOR_CHECK(space.dimension >= 1 && space.dimension <= most_dimensions, name, space.dimension);
  index_names_.push_back(std::move(name));
  index_spaces_.push_back(space);
  return static_cast<IndexId>(index_names_.size() - 1);
}

ParticleId ExprTree::add_particle(std::string name) {
  particle_names_.push_back(std::move(name));
  return static_cast<ParticleId>(particle_names_.size() - 1);
}

ExprId ExprTree::add(ExprNode node, std::span<const ExprId> children, std::span<const Slot> slots) {
  RIGOR_CHECK(node.op != Op::number && node.op != Op::table, static_cast<int>(node.op));
  return append(node, children, slots);
}

/// The spaces of the value's axes, as its children and slots make them. What is joined must be of one space.
AxisSpaces ExprTree::axes_of(const ExprNode& node, std::span<const ExprId> children,
                             std::span<const Slot> slots) const {
  const auto at = [&](std::size_t k) -> const ExprNode& { return (*this)[children[k]]; };
  const int op = static_cast<int>(node.op);
  switch (node.op) {
    case Op::symbol: {
      const AxisSpaces axes = symbols[node.symbol].axes;
      for (std::size_t k = 0; k < slots.size(); ++k) check_slot(slots[k], axes[static_cast<int>(k)]);
      return slots.empty() ? axes : AxisSpaces();
    }
    case Op::basis:
      check_slot(slots[0], node.axes[0]);
      return node.axes.first(1);
    case Op::component:
      for (std::size_t k = 0; k < slots.size(); ++k) check_slot(slots[k], at(0).axes[static_cast<int>(k)]);
      return {};
    case Op::epsilon:
      for (const Slot& slot : slots) check_slot(slot, common_space);
      return {};
    case Op::add:
    case Op::table:
    case Op::divide:
    case Op::negate:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::index_sum:
    case Op::particle_sum:
      if (node.op == Op::add || node.op == Op::table) {
        for (std::size_t k = 1; k < children.size(); ++k) RIGOR_CHECK(at(k).axes == at(0).axes, op, k);
      }
      return at(0).axes;
    case Op::multiply: {
      AxisSpaces axes;
      int rank = 0;
      for (std::size_t k = 0; k < children.size(); ++k) {
        axes = axes.then(rank, at(k).axes);
        rank += at(k).rank;
      }
      return axes;
    }
    case Op::dot: {
      const int last = at(0).rank - 1;
      RIGOR_CHECK(at(0).axes[last] == at(1).axes[0], op);
      return at(0).axes.first(last).then(last, at(1).axes.without_first(1));
    }
    case Op::cross:
    case Op::determinant:
      for (std::size_t k = 0; k < children.size(); ++k) RIGOR_CHECK(at(k).axes.are_common(), op, k);
      return {};
    case Op::tuple:
      RIGOR_CHECK(children.size() == node.axes[0].dimension, op, children.size());
      for (std::size_t k = 1; k < children.size(); ++k) RIGOR_CHECK(at(k).axes == at(0).axes, op, k);
      return node.axes.first(1).then(1, at(0).axes);
    default:
      return {};
  }
}

/// A literal axis is one of the space, and a variable runs over it.
void ExprTree::check_slot(const Slot& slot, Space of) const {
  if (slot.axis != 0) {
    RIGOR_CHECK(slot.axis <= of.dimension, slot.axis, of.dimension);
  } else {
    RIGOR_CHECK(space(slot.variable) == of, name(slot.variable), of.dimension);
  }
}

ExprId ExprTree::append(ExprNode node, std::span<const ExprId> children, std::span<const Slot> slots) {
  const int op = static_cast<int>(node.op);
  const Shape shape = shape_of(node.op);
  RIGOR_CHECK(shape.children == any_count || shape.children == children.size(), op, children.size());
  RIGOR_CHECK(shape.slots == any_count || shape.slots == slots.size(), op, slots.size());
  static thread_local std::vector<int> ranks;
  ranks.clear();
  std::uint64_t weight = 1;
  for (const ExprId child : children) {
    RIGOR_CHECK(static_cast<std::size_t>(child) < nodes_.size(), op, static_cast<std::uint32_t>(child));
    weight += nodes_[static_cast<std::size_t>(child)].weight;
    ranks.push_back(nodes_[static_cast<std::size_t>(child)].rank);
  }
  for (const Slot& slot : slots) {
    RIGOR_CHECK(slot.axis <= most_dimensions, op, slot.axis);
    RIGOR_CHECK(slot.axis != 0 || static_cast<std::size_t>(slot.variable) < index_names_.size(), op);
  }
  node.weight = static_cast<std::uint32_t>(std::min<std::uint64_t>(weight, 0xffffffffu));
  node.count = static_cast<std::uint32_t>(children.size());
  node.slot_count = static_cast<std::uint32_t>(slots.size());
  if (node.op == Op::symbol) {
    check_symbol(symbols, node);
  } else {
    RIGOR_CHECK(static_cast<int>(node.rank) == rank_of(node.op, ranks, node.slot_count), op, node.rank);
  }
  node.axes = axes_of(node, children, slots);
  if (node.op == Op::index_sum) RIGOR_CHECK(static_cast<std::size_t>(node.index) < index_names_.size(), op);
  if (node.particle != no_particle)
    RIGOR_CHECK(static_cast<std::size_t>(node.particle) < particle_names_.size(), op);
  if (node.op == Op::particle_sum) RIGOR_CHECK(node.particle != no_particle, op);
  node.first_child = children_.keep(children).data();
  node.first_slot = slots_.keep(slots).data();
  node.likeness = likeness_of(node);
  nodes_.push_back(node);
  return static_cast<ExprId>(nodes_.size() - 1);
}

ExprId ExprTree::add_number(Span span, std::string digits) {
  RIGOR_CHECK(is_decimal(digits), digits);
  ExprNode node{.op = Op::number, .span = span};
  node.payload = static_cast<std::uint32_t>(numbers_.size());
  numbers_.push_back(std::move(digits));
  return append(node, {}, {});
}

ExprId ExprTree::add_table(Span span, std::span<const ExprId> values, std::span<const Slot> slots,
                           Table table) {
  std::size_t tuples = 1;
  for (const Slot& slot : slots) tuples *= slot.axis == 0 ? space(slot.variable).dimension : 3u;
  RIGOR_CHECK(table.entry.size() == tuples, table.entry.size(), slots.size());
  for (const std::uint8_t entry : table.entry) RIGOR_CHECK(entry < values.size(), entry, values.size());
  ExprNode node{.op = Op::table, .span = span};
  node.rank = values.empty() ? std::uint8_t{0} : (*this)[values[0]].rank;
  node.payload = static_cast<std::uint32_t>(tables_.size());
  tables_.push_back(std::move(table));
  return append(node, values, slots);
}

const std::string& ExprTree::digits(ExprId id) const {
  RIGOR_CHECK((*this)[id].op == Op::number, static_cast<int>((*this)[id].op));
  return numbers_[(*this)[id].payload];
}

const Table& ExprTree::table(ExprId id) const {
  RIGOR_CHECK((*this)[id].op == Op::table, static_cast<int>((*this)[id].op));
  return tables_[(*this)[id].payload];
}

bool ExprTree::is_zero_literal(ExprId id) const {
  while ((*this)[id].op == Op::tuple) {
    const std::span<const ExprId> entries = children(id);
    if (std::ranges::any_of(entries, [&](ExprId each) { return each != entries[0]; }))
      return false;  // a written 0 given a rank has one entry, as often as there are axes
    id = entries[0];
  }
  if ((*this)[id].op != Op::number) return false;
  return std::ranges::all_of(digits(id), [](char c) { return c == '0' || c == '.'; });
}

std::vector<ExprId> nodes_below(const ExprTree& tree, std::vector<ExprId> roots) {
  std::vector<ExprId> nodes;
  static thread_local Marks reached;
  reached.clear(tree.size());
  std::ranges::reverse(roots);
  while (!roots.empty()) {
    const ExprId id = roots.back();
    roots.pop_back();
    if (!reached.mark(static_cast<std::size_t>(id))) continue;
    nodes.push_back(id);
    const auto children = tree.children(id);
    roots.insert(roots.end(), children.rbegin(), children.rend());
  }
  return nodes;
}

}  // namespace rigor
