// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/cyclic_image.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

using Cycle = std::array<std::string_view, 3>;

constexpr Cycle digits{"1", "2", "3"};
constexpr Cycle coordinates{"x", "y", "z"};
constexpr Cycle hatted{"i", "j", "k"};
constexpr Cycle dotless{"\\imath", "\\jmath", "k"};

/// Replaces a member of the cycle by the next one.
void turn(std::string& text, const Cycle& cycle) {
  const auto at = std::ranges::find(cycle, text);
  if (at != cycle.end()) text = at + 1 == cycle.end() ? cycle.front() : *(at + 1);
}

void turn(std::vector<WrittenIndex>& indices) {
  for (WrittenIndex& index : indices) turn(index.text, is_one_of(index.text, digits) ? digits : coordinates);
}

bool has_axis(const std::vector<WrittenIndex>& indices, const Cycle& cycle) {
  return std::ranges::any_of(indices,
                             [&](const WrittenIndex& index) { return is_one_of(index.text, cycle); });
}

/// A subscript that can be an axis: `i` and `1`, not `\alpha` and `\text{cm}`.
bool has_index(const std::vector<WrittenIndex>& indices) {
  return std::ranges::any_of(indices, [](const WrittenIndex& index) {
    return index.form == IndexForm::letter || index.form == IndexForm::digit;
  });
}

/// The letter itself is a coordinate or an axis: x, \dot{y}_\alpha, \hat{z}; not \mathbf{x} or x_i.
bool is_coordinate(const WrittenSymbol& symbol) {
  const bool face = symbol.face == Face::plain || symbol.accent == Accent::hat;
  return is_one_of(symbol.letter, coordinates) && face && !has_index(symbol.lower);
}

/// \hat{i}, \hat{\imath}, \hat{\mathbf{k}}.
bool is_hatted_axis(const WrittenSymbol& symbol) {
  return symbol.accent == Accent::hat && symbol.lower.empty() &&
         (is_one_of(symbol.letter, hatted) || is_one_of(symbol.letter, dotless));
}

bool is_basis_vector(const WrittenSymbol& symbol) {
  return symbol.letter == "e" && (symbol.face == Face::vector || symbol.accent == Accent::hat);
}

/// Visits every written symbol, with whether a derivative is by it, and the subscripts of brackets.
template <class Visit, class VisitIndices>
void for_each_symbol(const SyntaxTree& syntax, std::vector<SyntaxId> pending, const Visit& visit,
                     const VisitIndices& visit_indices) {
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    const SyntaxKind kind = syntax[id].kind;
    if (kind == SyntaxKind::symbol) visit(syntax.symbol(id), syntax[id].span, false);
    if (kind == SyntaxKind::component) visit_indices(syntax.indices(id));
    if (kind == SyntaxKind::derivative) {
      for (const WrittenVariable& variable : syntax.derivative(id).by)
        visit(variable.symbol, syntax[id].span, true);
    }
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
  }
}

/// The symbol with other axes.
void turn(WrittenSymbol& symbol, const WrittenAxes& axes) {
  if (axes.hatted && is_hatted_axis(symbol)) turn(symbol.letter, axes.dotless ? dotless : hatted);
  if (axes.letters && is_coordinate(symbol)) turn(symbol.letter, coordinates);
  turn(symbol.lower);
}

/// The node with other children.
SyntaxId image_of(SyntaxTree& syntax, SyntaxId id, const std::vector<SyntaxChild>& children,
                  const WrittenAxes& axes) {
  const SyntaxNode node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      WrittenSymbol symbol = syntax.symbol(id);
      turn(symbol, axes);
      return syntax.add_symbol(node.span, std::move(symbol));
    }
    case SyntaxKind::component: {
      std::vector<WrittenIndex> indices = syntax.indices(id);
      turn(indices);
      return syntax.add_component(node.span, children[0].id, std::move(indices));
    }
    case SyntaxKind::derivative: {
      WrittenDerivative derivative = syntax.derivative(id);
      for (WrittenVariable& variable : derivative.by) turn(variable.symbol, axes);
      return syntax.add_derivative(node.span, std::move(derivative), children[0].id);
    }
    default:
      return syntax.add(node.kind, node.span, children, node.payload);
  }
}

}  // namespace

WrittenAxes axes_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  WrittenAxes axes;
  bool any_digit = false;
  std::set<std::string> letters;
  Span coordinate;
  const auto see_indices = [&](const std::vector<WrittenIndex>& indices) {
    any_digit = any_digit || has_axis(indices, digits);
    axes.letters = axes.letters || has_axis(indices, coordinates);
  };
  const auto see = [&](const WrittenSymbol& symbol, Span span, bool by) {
    see_indices(symbol.lower);
    if (is_coordinate(symbol)) {
      letters.insert(symbol.letter);
      coordinate = span;
      axes.letters = axes.letters || by || symbol.accent == Accent::hat;
    }
    if (!is_hatted_axis(symbol)) return;
    if (symbol.letter == "k") return;  // which alone can be the direction of a vector
    axes.hatted = true;
    axes.dotless = axes.dotless || is_one_of(symbol.letter, dotless);
  };
  for_each_symbol(syntax, sides, see, see_indices);

  const auto stop = [&](Span place, DiagnosticKind kind, std::string message, std::string help) {
    axes.place = place;
    axes.obstacle = Obstacle{kind, std::move(message), {std::move(help)}};
  };
  const std::string help = "write the other two equations out";
  const auto doubt = [&](const WrittenSymbol& symbol, Span span, bool by) {
    const bool label = axes.letters && !by && !is_basis_vector(symbol) && has_axis(symbol.lower, digits);
    const bool other = axes.letters && !by && (symbol.letter == "y" || symbol.letter == "z") &&
                       symbol.face == Face::plain && has_index(symbol.lower);
    if (label || other)
      stop(span, DiagnosticKind::ambiguous_reading,
           "the axes here are x, y, z, so this subscript can be a label or an axis that is permuted", help);
    if (!axes.hatted && is_hatted_axis(symbol))
      stop(span, DiagnosticKind::ambiguous_reading,
           "`\\hat{k}` alone can be an axis that is permuted, or the direction of a vector", help);
  };
  for_each_symbol(syntax, sides, doubt, [](const auto&) {});
  if (any_digit && !axes.letters && letters.size() > 1)
    stop(coordinate, DiagnosticKind::ambiguous_reading,
         "the axes here are 1, 2, 3, so the letters x, y, z can be permuted, too, or stay", help);
  if (!any_digit && !axes.letters && !axes.hatted && !axes.obstacle) {
    const Span whole = cover(syntax[sides.front()].span, syntax[sides.back()].span);
    stop(whole, DiagnosticKind::unsupported,
         "there is nothing to permute: this equation has no axis 1, 2, 3 or x, y, z", help);
  }
  return axes;
}

SyntaxId cyclic_image(SyntaxTree& syntax, SyntaxId root, const WrittenAxes& axes) {
  struct Open {
    SyntaxId id;
    std::vector<SyntaxChild> children;
    std::size_t next = 0;
  };
  const auto open_node = [&](SyntaxId id) {
    const auto children = syntax.children(id);
    return Open{id, {children.begin(), children.end()}};
  };
  std::vector<Open> open{open_node(root)};
  while (true) {
    Open& top = open.back();
    if (top.next < top.children.size()) {
      open.push_back(open_node(top.children[top.next].id));
      continue;
    }
    const SyntaxId image = image_of(syntax, top.id, top.children, axes);
    open.pop_back();
    if (open.empty()) return image;
    open.back().children[open.back().next++].id = image;
  }
}

}  // namespace rigor
