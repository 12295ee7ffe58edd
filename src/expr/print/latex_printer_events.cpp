// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors of space-time with their indices above and below, and their derivatives: `F^{\mu\nu}`,
// `\Lambda^\mu{}_\nu`, `\partial_\mu A^\nu`, `\eta_{\mu\nu}`. A lowered index is a table of signs before the
// symbol (elaborate/reading/space_time.h).
#include <algorithm>
#include <utility>

#include "expr/print/latex_printer.h"

namespace rigor {
namespace {

bool is_space_time_slot(const ExprTree& tree, const Slot& slot) {
  return slot.axis == 0 && tree.space(slot.variable) == space_time;
}

/// σ at one slot.
bool is_signature(const ExprTree& tree, ExprId id) {
  return tree[id].op == Op::table && tree[id].slot_count == 1 && is_space_time_slot(tree, tree.slots(id)[0]);
}

bool has_event_axes(const ExprTree& tree, const ExprNode& node) {
  const Symbol& symbol = tree.symbols[node.symbol];
  for (int axis = 0; axis < static_cast<int>(node.slot_count); ++axis) {
    if (symbol.axes[axis] == space_time) return true;
  }
  return false;
}

/// The same symbol at the first and the last axis of space, through tuples: `p^i` is (p^1, p^2, p^3)_i.
ExprId spatial_leaf(const ExprTree& tree, ExprId id, std::size_t depth, bool last) {
  for (; depth > 0 && tree[id].op == Op::tuple && tree[id].count == 3; --depth)
    id = tree.children(id)[last ? 2 : 0];
  return id;
}

bool reaches_rate(const ExprTree& tree, ExprId id) {
  while (true) {
    const ExprNode& node = tree[id];
    if (tree.is_zero_literal(id)) return true;
    if (node.op == Op::divide || node.op == Op::component) {
      id = tree.children(id)[0];
    } else if (node.op == Op::tuple) {
      id = tree.children(id)[0];
    } else {
      return node.op == Op::symbol && tree.symbols[node.symbol].order(By::time) > 0;
    }
  }
}

}  // namespace

std::optional<LatexPrinter::EventPart> LatexPrinter::event_part(ExprId id) const {
  EventPart part;
  while (tree_[id].op == Op::multiply && tree_[id].count == 2 && is_signature(tree_, child(id))) {
    part.turned.push_back(tree_.slots(child(id))[0]);
    id = child(id, 1);
  }
  const ExprId whole = id;
  while (tree_[id].op == Op::component && tree_[id].slot_count == 1 && tree_[child(id)].op == Op::tuple &&
         tree_[child(id)].count == 4 && tree_[child(id)].axes[0] == space_time) {
    const ExprId tuple = child(id);
    if (!reaches_rate(tree_, child(tuple))) return std::nullopt;
    part.by.push_back(tree_.slots(id)[0]);
    id = child(tuple, 1);
  }
  const ExprNode& node = tree_[id];
  if (node.op == Op::component && part.by.empty()) {
    const std::size_t depth = node.slot_count;
    const ExprId first = spatial_leaf(tree_, child(id), depth, false);
    const ExprId last = spatial_leaf(tree_, child(id), depth, true);
    if (tree_[first].op != Op::symbol || tree_[last].op != Op::symbol ||
        tree_[first].symbol != tree_[last].symbol || !has_event_axes(tree_, tree_[first]))
      return std::nullopt;
    std::size_t which = 0;
    for (std::size_t k = 0; k < tree_[first].slot_count; ++k) {
      const Slot& from = tree_.slots(first)[k];
      const bool latin = from.axis == 2 && tree_.slots(last)[k].axis == 4;
      if (latin && which == depth) return std::nullopt;
      part.own.push_back(latin ? tree_.slots(id)[which++] : from);
    }
    if (which != depth) return std::nullopt;
    part.thing = first;
    part.symbol = tree_[first].symbol;
    return part;
  }
  part.thing = id;
  part.own.assign(tree_.slots(id).begin(), tree_.slots(id).end());
  if (node.op == Op::delta && id == whole) {
    const bool event =
        std::ranges::any_of(part.own, [&](const Slot& slot) { return is_space_time_slot(tree_, slot); });
    return event ? std::optional(part) : std::nullopt;
  }
  if (node.op == Op::table && node.slot_count == 4 && id == whole)
    return is_space_time_slot(tree_, part.own[0]) ? std::optional(part) : std::nullopt;
  if (node.op != Op::symbol) return std::nullopt;
  part.symbol = node.symbol;
  if (part.by.empty()) {
    const bool plain = has_event_axes(tree_, node) && tree_.symbols[node.symbol].order(By::space) == 0;
    return plain ? std::optional(part) : std::nullopt;
  }
  const auto& derivation = tree_.symbols[node.symbol].derivation;
  if (!derivation || derivation->by.count(By::space) < part.by.size() || part.own.size() < part.by.size())
    return std::nullopt;
  Derivation rest = *derivation;
  for (std::size_t k = 0; k < part.by.size(); ++k) {
    if (part.own.back().axis != 1) return std::nullopt;
    part.own.pop_back();
    rest.by.erase(By::space);
  }
  if (rest.by.count(By::space) > 0) return std::nullopt;
  const auto symbol = rest.by.empty() ? std::optional(rest.base) : tree_.symbols.find(rest);
  if (!symbol) return std::nullopt;
  part.symbol = *symbol;
  return part;
}

/// How often the letter stands on it.
std::size_t LatexPrinter::times_on(const EventPart& part, IndexId index) {
  const auto is_it = [&](const Slot& slot) { return slot.axis == 0 && slot.variable == index; };
  return static_cast<std::size_t>(std::ranges::count_if(part.own, is_it) +
                                  std::ranges::count_if(part.by, is_it));
}

std::string LatexPrinter::event_slot_text(const Slot& slot) const {
  return slot.axis == 0 ? slot_text(slot, false) : std::to_string(slot.axis - 1);
}

/// `^{\mu}{}_{\nu}` behind a letter with labels.
std::string LatexPrinter::staggered(const std::string& labels,
                                    const std::vector<std::pair<std::string, bool>>& indices) {
  std::string text;
  std::string group = labels;
  bool above = false;
  bool any = false;  // a group was written that is no label
  const auto close = [&] {
    if (group.empty()) return;
    text += above ? "^{" + group + "}" : subscript(group);
    group.clear();
  };
  for (const auto& [index, is_above] : indices) {
    if (is_above != above) {
      close();
      if (any) text += "{}";
    }
    above = is_above;
    append_latex(group, index);
    any = true;
  }
  close();
  return text;
}

std::string LatexPrinter::event_indices(const std::string& labels, std::span<const Slot> slots,
                                        std::vector<Slot>& turned, SymbolId symbol) const {
  std::vector<std::pair<std::string, bool>> indices;
  const auto known = notation_.heights.find(symbol);
  for (std::size_t k = slots.size(); k-- > 0;) {
    const auto at = std::ranges::find_if(turned, [&](const Slot& each) { return same_slot(each, slots[k]); });
    const bool as_stored = at == turned.end();
    if (!as_stored) turned.erase(at);
    const bool stored_above =
        known == notation_.heights.end() || k >= known->second.size() || known->second[k] == 'u';
    const bool above = as_stored == stored_above;
    indices.insert(indices.begin(), {event_slot_text(slots[k]), above});
  }
  return staggered(labels, indices);
}

std::optional<LatexPrinter::Piece> LatexPrinter::event(ExprId id) {
  const auto part = event_part(id);
  if (!part) return std::nullopt;
  std::vector<Slot> turned = part->turned;
  const auto take = [&](const Slot& slot) {
    const auto at = std::ranges::find_if(turned, [&](const Slot& each) { return same_slot(each, slot); });
    if (at == turned.end()) return false;
    turned.erase(at);
    return true;
  };
  const ExprNode& thing = tree_[part->thing];
  if (thing.op == Op::delta) {
    const std::string first = event_slot_text(part->own[0]);
    const std::string second = event_slot_text(part->own[1]);
    const bool low = take(part->own[0]);
    const bool high = take(part->own[1]);
    if (low == high)
      return Piece{"\\delta^{" + (low ? second : first) + "}_{" + (low ? first : second) + "}"};
    std::string both = first;
    append_latex(both, second);
    return Piece{notation_.metric + (low ? "_{" : "^{") + both + "}"};
  }
  std::vector<bool> raised;  // ∂^\mu
  for (const Slot& slot : part->by) raised.push_back(take(slot));
  if (thing.op == Op::table) return Piece{notation_.epsilon + event_indices("", part->own, turned, {})};
  const Symbol& symbol = tree_.symbols[part->symbol];
  const SymbolId base = base_of(tree_.symbols, part->symbol);
  Piece result;
  if (part->own.empty() || !symbol.derivation) {
    ExprNode node = thing;
    const LatexName name = name_of(part->symbol);
    if (symbol.derivation) return std::nullopt;
    result = part->own.empty() ? plain_symbol(part->symbol, node, {}, 0)
                               : Piece{without_face(name.letter) + name.primes +
                                       event_indices(name.labels, part->own, turned, base)};
  } else {
    const LatexName name = name_of(symbol.derivation->base);
    result =
        Piece{without_face(name.letter) + name.primes + event_indices(name.labels, part->own, turned, base)};
    result = by_letters(std::move(result), *symbol.derivation);
    const int rates = symbol.order(By::time);
    if (rates > 0) {
      const std::string order = rates == 1 ? "" : "^" + std::to_string(rates);
      result = differentiated(std::move(result), "\\partial" + order, "\\partial t" + order);
    }
  }
  for (std::size_t k = part->by.size(); k-- > 0;) {
    const std::string index = event_slot_text(part->by[k]);
    std::string text = raised[k] ? "\\partial^{" + index + "}" : "\\partial" + subscript(index);
    if (result.text.front() != '\\') text += ' ';
    append_latex(text, result.text);
    result = {text, Level::factor, true};
  }
  return result;
}

}  // namespace rigor
