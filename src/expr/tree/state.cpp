// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/state.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "base/ascii.h"

namespace rigor {
namespace {

[[nodiscard]] bool is_number_text(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.size() < 6 && std::ranges::all_of(text, is_digit);
}

[[nodiscard]] int number_of_text(std::string_view text) {
  int value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// `n`, `\nu`, `n'`, `n_{1}`, without what stands above: the length of the letter, or 0.
[[nodiscard]] std::size_t length_of_letter(std::string_view text) {
  std::size_t at = 0;
  if (text.empty()) return 0;
  if (text[0] == '\\') {
    for (at = 1; at < text.size() && is_letter(text[at]);) ++at;
    if (at == 1) return 0;
  } else if (is_letter(text[0])) {
    at = 1;
  } else {
    return 0;
  }
  while (at < text.size() && text[at] == '\'') ++at;
  if (text.substr(at).starts_with("_{")) {
    const std::size_t end = text.find('}', at);
    if (end == std::string_view::npos || text.find('{', at + 2) < end) return 0;
    at = end + 1;
  }
  while (at < text.size() && text[at] == '\'') ++at;
  return at;
}

[[nodiscard]] LabelPart part_of_label(std::string_view text);

/// `\psi_{n}`: the state n of the \psi. n_1 and n_2 are numbers of their own.
[[nodiscard]] std::optional<LabelPart> member_of_states(std::string_view text) {
  const std::size_t script = text.find("_{");
  if (script == std::string_view::npos || script == 0 || text.back() != '}') return std::nullopt;
  const std::string_view of = text.substr(0, script);
  const std::string_view number = text.substr(script + 2, text.size() - script - 3);
  if (length_of_letter(of) != of.size() || number.find_first_of("{}_") != std::string_view::npos ||
      numbers_states({std::string(of), "", 0}))
    return std::nullopt;
  LabelPart part = part_of_label(number);
  if (!part.mark.empty() || (!part.letter.empty() && !numbers_states(part))) return std::nullopt;
  part.mark = of;
  return part;
}

[[nodiscard]] LabelPart part_of_label(std::string_view text) {
  if (auto member = member_of_states(text)) return *std::move(member);
  if (is_number_text(text)) return {"", "", number_of_text(text)};
  const std::size_t length = length_of_letter(text);
  LabelPart part{std::string(text.substr(0, length)), "", 0};
  std::string_view rest = text.substr(length);
  if (length > 0 && rest.starts_with("^{(")) {
    const std::size_t end = rest.find(")}");
    if (end != std::string_view::npos) {
      part.mark = rest.substr(0, end + 2);
      rest.remove_prefix(end + 2);
    }
  }
  if (length > 0 && rest.empty()) return part;
  const bool shifted =
      length > 0 && (rest[0] == '+' || rest[0] == '-') && is_number_text(rest.substr(1)) && rest[1] != '-';
  if (!shifted) return {std::string(text), "", 0};
  part.number = number_of_text(rest);
  return part;
}

[[nodiscard]] StateShape turned(StateShape shape) {
  if (shape == StateShape::ket) return StateShape::bra;
  return shape == StateShape::bra ? StateShape::ket : shape;
}

[[nodiscard]] StateShape product_shape(StateShape a, StateShape b) {
  using enum StateShape;
  if (a == none || b == none) return none;
  if (a == number) return b;
  if (b == number) return a;
  if (a == ket) return b == bra ? operators : none;
  if (a == bra) return b == ket ? number : b == operators ? bra : none;
  return b == bra ? none : b;
}

[[nodiscard]] StateShape sum_shape(StateShape a, StateShape b) {
  using enum StateShape;
  if (a == b) return a;
  const bool unit = (a == number && b == operators) || (a == operators && b == number);
  return unit ? operators : none;
}

}  // namespace

std::vector<LabelPart> label_of(std::string_view text) {
  std::vector<LabelPart> label;
  while (true) {
    const std::size_t comma = text.find(", ");
    label.push_back(part_of_label(text.substr(0, comma)));
    if (comma == std::string_view::npos) return label;
    text.remove_prefix(comma + 2);
  }
}

std::string text_of_label(const std::vector<LabelPart>& label) {
  std::string text;
  for (const LabelPart& part : label) {
    if (!text.empty()) text += ", ";
    const bool member = !part.mark.empty() && part.mark[0] != '^';
    if (member) text += part.mark + "_{";
    if (part.letter.empty()) {
      text += std::to_string(part.number);
    } else {
      text += part.letter + (member ? "" : part.mark);
      if (part.number > 0) text += " + " + std::to_string(part.number);
      if (part.number < 0) text += " - " + std::to_string(-part.number);
    }
    if (member) text += "}";
  }
  return text;
}

bool numbers_states(const LabelPart& part) {
  return !part.letter.empty() && part.letter[0] >= 'i' && part.letter[0] <= 'n' &&
         (part.letter.size() == 1 || part.letter[1] == '\'' || part.letter[1] == '_');
}

SymbolId symbol_of_ket(ExprTree& tree, const std::vector<LabelPart>& label, Span span) {
  for (std::uint32_t k = 0; k < tree.symbols.size(); ++k) {
    const Symbol& known = tree.symbols[SymbolId{k}];
    if (known.ket && !known.derivation && known.label == label) return SymbolId{k};
  }
  Symbol symbol;
  symbol.name = "|" + text_of_label(label) + "\\rangle";
  symbol.complex = true;
  symbol.noncommuting = true;
  symbol.first_seen = span;
  symbol.made_at = tree.size();
  symbol.ket = true;
  symbol.label = label;
  return tree.symbols.add(std::move(symbol));
}

ExprId kronecker_of_states(ExprTree& tree, LabelPart first, LabelPart second, Span span) {
  if (first == second) return tree.add_number(span, "1");
  if (first.letter == second.letter && first.mark == second.mark) return tree.add_number(span, "0");
  if (second < first) std::swap(first, second);
  const int shift = first.letter.empty() ? 0 : first.number;  // δ with n + 1 and m + 1 is that with n and m
  first.number -= shift;
  second.number -= second.letter.empty() ? 0 : shift;
  const std::vector<LabelPart> label{first, second};
  for (std::uint32_t k = 0; k < tree.symbols.size(); ++k) {
    const Symbol& known = tree.symbols[SymbolId{k}];
    if (is_kronecker_of_states(known) && known.label == label)
      return tree.add({.op = Op::symbol, .span = span, .symbol = SymbolId{k}});
  }
  Symbol symbol;
  symbol.name = "\\delta_{" + text_of_label({first}) + "," + text_of_label({second}) + "}";
  std::erase(symbol.name, ' ');
  symbol.first_seen = span;
  symbol.made_at = tree.size();
  symbol.label = label;
  const SymbolId made = tree.symbols.add(std::move(symbol));
  return tree.add({.op = Op::symbol, .span = span, .symbol = made});
}

bool holds_states(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) {
    return tree[id].op == Op::symbol && tree.symbols[tree[id].symbol].ket;
  });
}

StateShape state_shape(const ExprTree& tree, ExprId root) {
  const ExprNode& node = tree[root];
  const auto children = tree.children(root);
  const auto of = [&](std::size_t k) { return state_shape(tree, children[k]); };
  switch (node.op) {
    case Op::symbol: {
      const Symbol& symbol = tree.symbols[node.symbol];
      if (symbol.ket) return StateShape::ket;
      return symbol.noncommuting ? StateShape::operators : StateShape::number;
    }
    case Op::add: {
      StateShape shape = of(0);
      for (std::size_t k = 1; k < children.size(); ++k) {
        if (!tree.is_zero_literal(children[k])) shape = sum_shape(shape, of(k));
      }
      return shape;
    }
    case Op::multiply:
    case Op::dot:
    case Op::cross: {
      StateShape shape = of(0);
      for (std::size_t k = 1; k < children.size(); ++k) shape = product_shape(shape, of(k));
      return shape;
    }
    case Op::divide:
      return of(1) == StateShape::number ? of(0) : StateShape::none;
    case Op::negate:
    case Op::component:
    case Op::index_sum:
    case Op::particle_sum:
      return of(0);
    case Op::conjugate:
      return turned(of(0));
    case Op::trace:
    case Op::matrix_determinant:
      return of(0) == StateShape::operators ? StateShape::number : StateShape::none;
    default: {
      StateShape shape = StateShape::number;
      for (std::size_t k = 0; k < children.size(); ++k) shape = sum_shape(shape, of(k));
      return shape == StateShape::number || shape == StateShape::operators ? shape : StateShape::none;
    }
  }
}

}  // namespace rigor
