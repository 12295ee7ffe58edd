// SPDX-License-Identifier: GPL-3.0-or-later
// Walks over a whole tree, with a stack of their own: depth costs no call stack.
#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "expr/tree/marks.h"
#include "expr/tree/tree.h"

namespace rigor {
namespace {

[[nodiscard]] std::string_view name_of(Op op) {
  static constexpr auto names = std::to_array<std::string_view>({"number",      "symbol",
                                                                 "e",           "delta",
                                                                 "epsilon",     "add",
                                                                 "negate",      "multiply",
                                                                 "divide",      "power",
                                                                 "real-power",  "root",
                                                                 "length",      "absolute",
                                                                 "dot",         "cross",
                                                                 "component",   "tuple",
                                                                 "determinant", "i",
                                                                 "conjugate",   "re",
                                                                 "im",          "transpose",
                                                                 "trace",       "matrix-determinant",
                                                                 "index-sum",   "particle-sum",
                                                                 "function",    "table"});
  static_assert(names.size() == static_cast<std::size_t>(Op::table) + 1);
  return names[static_cast<std::size_t>(op)];
}

[[nodiscard]] std::string_view name_of(Function function) {
  switch (function) {
    case Function::sin:
      return "sin";
    case Function::cos:
      return "cos";
    case Function::exp:
      return "exp";
    case Function::log:
      return "log";
    case Function::arcsin:
      return "arcsin";
    case Function::arccos:
      return "arccos";
    case Function::arctan:
      return "arctan";
  }
  return "?";
}

[[nodiscard]] std::string slots_text(const ExprTree& tree, ExprId id) {
  std::string text;
  for (const Slot& slot : tree.slots(id)) {
    text += text.empty() ? '[' : ',';
    text += slot.axis != 0 ? std::to_string(slot.axis) : tree.name(slot.variable);
  }
  return text.empty() ? text : text + ']';
}

/// What stands for a node before its children: `r{\alpha}[i]`, `index-sum i`.
[[nodiscard]] std::string head(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  if (node.op == Op::number) return tree.digits(id);
  if (node.op == Op::function) return std::string(name_of(node.function));
  std::string text{node.op == Op::symbol ? std::string_view(tree.symbols[node.symbol].name)
                                         : name_of(node.op)};
  if (node.op == Op::symbol && node.particle != no_particle) text += '{' + tree.name(node.particle) + '}';
  if (node.op == Op::index_sum) text += ' ' + tree.name(node.index);
  if (node.op == Op::particle_sum) text += ' ' + tree.name(node.particle);
  text += slots_text(tree, id);
  if (node.op != Op::table) return text;
  char separator = ':';
  for (const std::uint8_t entry : tree.table(id).entry) {
    text += separator + std::to_string(entry);
    separator = ',';
  }
  return text;
}

}  // namespace

bool names_an_axis(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) {
    return tree[id].op == Op::basis ||
           std::ranges::any_of(tree.slots(id), [](const Slot& slot) { return slot.axis != 0; });
  });
}

bool has_operators(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) {
    return tree[id].op == Op::symbol && tree.symbols[tree[id].symbol].noncommuting;
  });
}

bool has_complex_numbers(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) {
    const ExprNode& node = tree[id];
    return node.op == Op::imaginary_unit || (node.op == Op::symbol && tree.symbols[node.symbol].complex);
  });
}

bool is_of_common_space(const ExprTree& tree, ExprId root) {
  const auto leaves = [&](const Slot& slot) {
    return slot.axis == 0 && tree.space(slot.variable) != common_space;
  };
  return std::ranges::all_of(nodes_below(tree, {root}), [&](ExprId id) {
    const ExprNode& node = tree[id];
    if (!node.axes.are_common() || std::ranges::any_of(tree.slots(id), leaves)) return false;
    if (node.op == Op::symbol && !tree.symbols[node.symbol].axes.are_common()) return false;
    return node.op != Op::index_sum || tree.space(node.index) == common_space;
  });
}

std::vector<SymbolId> symbols_in(const ExprTree& tree, ExprId root) {
  std::vector<SymbolId> found;
  static thread_local Marks seen;
  static thread_local Marks visited;  // parts are shared
  seen.clear(tree.symbols.size());
  visited.clear(tree.size());
  std::vector<ExprId> open{root};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!visited.mark(static_cast<std::size_t>(id))) continue;
    if (tree[id].op == Op::symbol && seen.mark(static_cast<std::size_t>(tree[id].symbol)))
      found.push_back(tree[id].symbol);
    const auto children = tree.children(id);
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return found;
}

std::string dump(const ExprTree& tree, ExprId root) {
  std::string text;
  std::vector<std::variant<ExprId, std::string>> open{root};  // nodes to come, and text between them
  while (!open.empty()) {
    const auto next = std::move(open.back());
    open.pop_back();
    if (const auto* between = std::get_if<std::string>(&next)) {
      text += *between;
      continue;
    }
    const ExprId id = std::get<ExprId>(next);
    const auto children = tree.children(id);
    if (children.empty()) {
      text += head(tree, id);
      continue;
    }
    text += '(' + head(tree, id);
    open.emplace_back(")");
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      if (tree[id].op == Op::power && child == children.rbegin()) {
        open.emplace_back(' ' + std::to_string(tree[id].exponent));
      }
      open.emplace_back(*child);
      open.emplace_back(" ");
    }
  }
  return text;
}

}  // namespace rigor
