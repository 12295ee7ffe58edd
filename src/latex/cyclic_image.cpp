// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/cyclic_image.h"

#include <string_view>
#include <utility>
#include <vector>

namespace rigor {
namespace {

void turn(std::vector<WrittenIndex>& indices) {
  static constexpr std::string_view cycles[] = {"1231", "xyzx"};
  for (WrittenIndex& index : indices) {
    if (index.text.size() != 1) continue;
    for (const std::string_view cycle : cycles) {
      const auto at = cycle.find(index.text[0]);
      if (at == std::string_view::npos) continue;
      index.text = cycle.substr(at + 1, 1);
      break;
    }
  }
}

/// The node with other children.
SyntaxId image_of(SyntaxTree& syntax, SyntaxId id, const std::vector<SyntaxChild>& children) {
  const SyntaxNode node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      WrittenSymbol symbol = syntax.symbol(id);
      turn(symbol.lower);
      return syntax.add_symbol(node.span, std::move(symbol));
    }
    case SyntaxKind::component: {
      std::vector<WrittenIndex> indices = syntax.indices(id);
      turn(indices);
      return syntax.add_component(node.span, children[0].id, std::move(indices));
    }
    case SyntaxKind::derivative: {
      WrittenDerivative derivative = syntax.derivative(id);
      for (WrittenVariable& variable : derivative.by) turn(variable.symbol.lower);
      return syntax.add_derivative(node.span, std::move(derivative), children[0].id);
    }
    default:
      return syntax.add(node.kind, node.span, children, node.payload);
  }
}

}  // namespace

SyntaxId cyclic_image(SyntaxTree& syntax, SyntaxId root) {
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
    const SyntaxId image = image_of(syntax, top.id, top.children);
    open.pop_back();
    if (open.empty()) return image;
    open.back().children[open.back().next++].id = image;
  }
}

}  // namespace rigor
